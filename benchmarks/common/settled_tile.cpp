// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/settled_tile.hpp"

#include <unistd.h>

#include <array>
#include <fstream>
#include <iostream>
#include <limits>

#include "benchmarks/common/scenes.hpp"
#include "input/sphere_grid.hpp"
#include "input/uniform.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "report/files.hpp"

namespace grainproof::bench {
namespace {

namespace fs = std::filesystem;

constexpr int particles_per_area = 25;  // for a square diameter of floor
constexpr double height = 60.0 * diameter;
constexpr double loose_height = 44.0 * diameter;  // a packing of 0.3, which random addition still reaches

/// The weight is first taken larger, so that the fall is short, and then let down to its own.
struct Stage {
  double weights;
  std::int64_t steps;
};
constexpr std::array stages{Stage{10.0, 12000}, Stage{3.0, 6000}, Stage{1.0, 12000}};

/// Laws that lose most of the energy of every impact, so that the bed is at rest soon.
Scene settling_bed(double side, double gravity) {
  Scene scene = empty_bed(side, side);
  ContactLaws laws = usual_laws();
  std::get<LinearNormal>(laws.normal).dissipation = Restitution{0.1};
  scene.contacts.set(0, 0, laws);
  scene.gravity = ConstantGravity{Vec3(0.0, 0.0, -gravity)};
  return scene;
}

std::vector<Vec3> loose(const Domain& domain, std::size_t count) {
  input::SphereGrid grid(domain, diameter, count);
  input::Uniform uniform(1);
  std::vector<Vec3> positions;
  while (positions.size() < count) {
    const Vec3 position(domain.upper.x() * uniform(), domain.upper.y() * uniform(),
                        0.5 * diameter + loose_height * uniform());
    if (grid.any_near(position, [&](std::size_t other) {
          return input::nearest_image(domain, positions[other], position).norm() < diameter;
        }))
      continue;
    grid.insert(positions.size(), position);
    positions.push_back(position);
  }
  return positions;
}

Frame run_for(Scene scene, const Frame& from, std::int64_t steps) {
  for (std::size_t i = 0; i < from.position.size(); ++i)
    scene.particles.push_back({.id = static_cast<std::int64_t>(i) + 1,
                               .material = 0,
                               .diameter = diameter,
                               .effect_diameter = diameter,
                               .position = from.position[i],
                               .velocity = from.velocity[i]});
  reference::ReferenceEngine engine;
  const auto run = engine.start(scene, {});
  run->advance(steps);
  return run->frame();
}

std::vector<Vec3> settle(int side) {
  const double length = side * diameter;
  Frame frame;
  frame.position =
      loose(settling_bed(length, 0.0).domain, static_cast<std::size_t>(particles_per_area * side * side));
  frame.velocity.assign(frame.position.size(), Vec3::Zero());
  for (const Stage& stage : stages)
    frame = run_for(settling_bed(length, stage.weights * 9.81), frame, stage.steps);
  return frame.position;
}

std::vector<Vec3> read_positions(const fs::path& file) {
  std::ifstream in(file);
  std::vector<Vec3> positions;
  for (Vec3 p; in >> p.x() >> p.y() >> p.z();) positions.push_back(p);
  return positions;
}

/// Under a name of its own first, so that another program never reads half of it.
void write_positions(const fs::path& file, const std::vector<Vec3>& positions) {
  fs::create_directories(file.parent_path());
  const fs::path unfinished = file.string() + "." + std::to_string(getpid());
  std::ofstream out(unfinished);
  out.precision(std::numeric_limits<double>::max_digits10);
  for (const Vec3& p : positions) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  out.close();
  report::require_written(out, unfinished);
  fs::rename(unfinished, file);
}

}  // namespace

Scene empty_bed(double along_x, double along_y) {
  Scene scene = empty_scene(Vec3(along_x, along_y, height));
  scene.domain.boundary[2] = Boundary::open;
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}});
  scene.gravity = ConstantGravity{Vec3(0.0, 0.0, -9.81)};
  return scene;
}

SettledTile settled_tile(int side, const fs::path& cache) {
  const auto wanted = static_cast<std::size_t>(particles_per_area * side * side);
  const fs::path file = cache / ("bed_tile_" + std::to_string(side) + ".txt");
  std::vector<Vec3> positions = read_positions(file);
  if (positions.size() != wanted) {
    std::cout << "note: settling a bed of " << wanted << " particles, once; it is kept in " << file.string()
              << std::endl;
    positions = settle(side);
    write_positions(file, positions);
  }
  return {side * diameter, std::move(positions)};
}

}  // namespace grainproof::bench
