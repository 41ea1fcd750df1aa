// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/neighbours/neighbours.hpp"

#include <algorithm>
#include <limits>

#include "reference_cpu/neighbours/all_pairs.hpp"

namespace grainproof::reference {
namespace {

/// Up to here looking at every pair costs less than keeping a list up to date.
constexpr std::size_t few_particles = 8;

/// In radii of the smallest particle. Wider lists last longer and cost more each step.
constexpr double usual_skin = 0.2;

double skin_of(const Scene& scene) {
  return scene.run.skin >= 0.0 ? scene.run.skin : usual_skin * smallest_reach(scene);
}

}  // namespace

Neighbours::Neighbours(const Scene& scene, const Walls& walls, const Bodies& bodies, const PeriodicBox& box)
    : way_(way_for(scene, bodies)),
      walls_(walls),
      box_(box),
      largest_reach_(largest_reach(scene)),
      verlet_(skin_of(scene)),
      near_walls_(walls.size()) {}

Neighbours::Way Neighbours::way_for(const Scene& scene, const Bodies& bodies) {
  const bool all_fixed = std::ranges::all_of(bodies.body, &Body::fixed);
  if (bodies.size() < 2 || all_fixed) return Way::nothing_to_find;
  switch (scene.run.neighbours) {
    case NeighbourSearch::all_pairs:
      return Way::all_pairs;
    case NeighbourSearch::cells:
      return Way::cells;
    case NeighbourSearch::verlet_list:
      return Way::verlet_list;
    case NeighbourSearch::automatic:
      break;
  }
  return bodies.size() <= few_particles ? Way::all_pairs : Way::verlet_list;
}

bool Neighbours::outdated(const Bodies& bodies) const {
  if (lists_ == 0) return true;
  if (way_ == Way::verlet_list)
    return verlet_.outdated(bodies, box_) || near_walls_.outdated(walls_, verlet_.skin());
  return way_ != Way::nothing_to_find;
}

double Neighbours::skin() const {
  if (way_ == Way::nothing_to_find) return std::numeric_limits<double>::infinity();
  return way_ == Way::verlet_list ? verlet_.skin() : 0.0;
}

void Neighbours::list(const Bodies& bodies) {
  if (way_ == Way::nothing_to_find) {
    pairs_.assign(bodies.size(), {});
  } else if (way_ == Way::all_pairs) {
    list_all_pairs(bodies, box_, skin(), pairs_);
  } else {
    fill_cells(bodies);
    chains_.list_pairs(bodies, box_, skin(), pairs_);
  }
  near_walls_.list(walls_, bodies, box_, skin());
  if (way_ == Way::verlet_list) verlet_.made(bodies);
  ++lists_;
}

void Neighbours::fill_cells(const Bodies& bodies) {
  chains_.fill(grid_over(bodies, box_, 2.0 * largest_reach_ + skin()), bodies);
}

void Neighbours::pack_into(Sections& own) const {
  pack_one(own, "neighbours.lists", lists_);
  pairs_.pack_into(own);
  near_walls_.pack_into(own);
  verlet_.pack_into(own);
}

void Neighbours::unpack_from(const Sections& own) {
  unpack_one(own, "neighbours.lists", lists_);
  pairs_.unpack_from(own);
  near_walls_.unpack_from(own);
  verlet_.unpack_from(own);
}

std::vector<std::int32_t> Neighbours::order_in_space(const Bodies& bodies) {
  fill_cells(bodies);
  return chains_.order();
}

}  // namespace grainproof::reference
