// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/neighbours/near_walls.hpp"

#include "reference_cpu/surfaces.hpp"

namespace grainproof::reference {
namespace {

template <class Shape>
void list_near(const Shape& shape, const Bodies& bodies, const PeriodicBox& box, double skin,
               std::vector<std::int32_t>& near) {
  near.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies.body[i];
    const double range = (bodies.reach[i] + skin) * (1.0 + 1e-12);
    if (!body.fixed() && nearest(shape, body.position, box).distance < range)
      near.push_back(static_cast<std::int32_t>(i));
  }
}

}  // namespace

void NearWalls::list(const Walls& walls, const Bodies& bodies, const PeriodicBox& box, double skin) {
  reference_when_made_.resize(walls.size());
  for (std::size_t w = 0; w < walls.size(); ++w) {
    reference_when_made_[w] = walls[w].reference;
    std::visit([&](const auto& shape) { list_near(shape, bodies, box, skin, near_[w]); }, walls[w].shape);
  }
}

void NearWalls::pack_into(Sections& own) const {
  pack(own, "near_walls.reference_when_made", reference_when_made_);
  for (std::size_t w = 0; w < near_.size(); ++w) pack(own, "near_walls." + std::to_string(w), near_[w]);
}

void NearWalls::unpack_from(const Sections& own) {
  unpack(own, "near_walls.reference_when_made", reference_when_made_);
  for (std::size_t w = 0; w < near_.size(); ++w) unpack(own, "near_walls." + std::to_string(w), near_[w]);
}

bool NearWalls::outdated(const Walls& walls, double skin) const {
  for (std::size_t w = 0; w < walls.size(); ++w)
    if (4.0 * (walls[w].reference - reference_when_made_[w]).squaredNorm() > skin * skin) return true;
  return false;
}

}  // namespace grainproof::reference
