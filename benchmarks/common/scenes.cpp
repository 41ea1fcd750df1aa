// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/scenes.hpp"

#include <cmath>
#include <numbers>

#include "benchmarks/common/settled_tile.hpp"
#include "input/sphere_grid.hpp"
#include "input/uniform.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

struct Tiling {
  std::int64_t along_x, along_y;
};

/// As square as the number allows.
Tiling tiling_of(std::int64_t tiles) {
  auto across = static_cast<std::int64_t>(std::sqrt(static_cast<double>(tiles)));
  while (tiles % across != 0) --across;
  return {tiles / across, across};
}

Vec3 normal_deviates(input::Uniform& uniform) {
  Vec3 out;
  for (int axis = 0; axis < 3; ++axis)
    out[axis] = std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * std::numbers::pi * uniform());
  return out;
}

void add_particle(Scene& scene, const Vec3& position, const Vec3& velocity) {
  const auto id = static_cast<std::int64_t>(scene.particles.size()) + 1;
  scene.particles.push_back({.id = id,
                             .material = 0,
                             .diameter = diameter,
                             .effect_diameter = diameter,
                             .position = position,
                             .velocity = velocity});
}

/// Random sequential addition.
void fill_at_random(Scene& scene, std::int64_t particles) {
  input::SphereGrid grid(scene.domain, diameter, static_cast<std::size_t>(particles));
  input::Uniform uniform(1);
  while (static_cast<std::int64_t>(scene.particles.size()) < particles) {
    const Vec3 share(uniform(), uniform(), uniform());
    const Vec3 position = scene.domain.lower + scene.domain.extent().cwiseProduct(share);
    if (grid.any_near(position, [&](std::size_t other) {
          return input::nearest_image(scene.domain, scene.particles[other].position, position).norm() <
                 diameter;
        }))
      continue;
    grid.insert(scene.particles.size(), position);
    add_particle(scene, position, normal_deviates(uniform) / std::numbers::sqrt3);
  }
}

}  // namespace

ContactLaws usual_laws() {
  return {.normal = LinearNormal{stiffness, Restitution{restitution}},
          .friction = HistoryFriction{friction, 2.0 / 7.0 * stiffness, 0.5}};
}

Scene empty_scene(const Vec3& extent) {
  Scene scene;
  scene.run = {.end = 1.0, .step = time_step, .sample_times = {0.0, 1.0}};
  scene.domain = {Vec3::Zero(), extent, {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
  scene.materials = {{"glass", density}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, usual_laws());
  scene.rotation = true;
  return scene;
}

Scene bed(std::int64_t particles, const std::filesystem::path& cache) {
  const SettledTile tile = settled_tile(particles < tile_particles ? small_tile_side : tile_side, cache);
  const auto tiles = std::max<std::int64_t>(1, particles / static_cast<std::int64_t>(tile.positions.size()));
  const auto [along_x, along_y] = tiling_of(tiles);
  Scene scene = empty_bed(tile.side * static_cast<double>(along_x), tile.side * static_cast<double>(along_y));
  scene.particles.reserve(static_cast<std::size_t>(tiles) * tile.positions.size());
  for (std::int64_t x = 0; x < along_x; ++x)
    for (std::int64_t y = 0; y < along_y; ++y)
      for (const Vec3& position : tile.positions)
        add_particle(scene, position + tile.side * Vec3(static_cast<double>(x), static_cast<double>(y), 0.0),
                     Vec3::Zero());
  return scene;
}

Scene gas(std::int64_t particles) {
  const double volume =
      static_cast<double>(particles) * std::numbers::pi / 6.0 * std::pow(diameter, 3) / gas_packing;
  Scene scene = empty_scene(Vec3::Constant(std::cbrt(volume)));
  scene.particles.reserve(static_cast<std::size_t>(particles));
  fill_at_random(scene, particles);
  return scene;
}

Scene scene_named(const std::string& name, std::int64_t particles, const std::filesystem::path& cache) {
  if (name == "bed") return bed(particles, cache);
  if (name == "gas") return gas(particles);
  throw InputRefused("no benchmark scene " + name + "; there are bed and gas");
}

std::string sized_name(const std::string& name, std::int64_t particles) {
  if (particles % 1000000 == 0) return name + "_" + std::to_string(particles / 1000000) + "m";
  if (particles % 1000 == 0) return name + "_" + std::to_string(particles / 1000) + "k";
  return name + "_" + std::to_string(particles);
}

}  // namespace grainproof::bench
