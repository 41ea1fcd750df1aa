// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/settling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

constexpr double diameter = 0.1;
constexpr double density = 2000.0;
constexpr double stiffness = 1e5;
constexpr double weight = 9.81;
constexpr int last_steps = 64;

Scene settling_scene(Integrator integrator, double step, double end) {
  Scene scene;
  scene.title = "settling";
  scene.run.end = end;
  scene.run.step = step;
  scene.run.integrator = integrator;
  scene.run.sample_times = {0.0, end};
  scene.domain = {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
  scene.materials = {{"glass", density}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{stiffness, Restitution{0.8}}});
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}});
  scene.particles.push_back({1, 0, false, diameter, diameter, 0.5 * diameter * Vec3::UnitZ(), Vec3::Zero()});
  scene.gravity = ConstantGravity{-weight * Vec3::UnitZ()};
  return scene;
}

}  // namespace

std::vector<double> settling_steps(bool quick) {
  if (quick) return {2e-4, 8e-4, 9.1e-4, 9.3e-4, 9.7e-4};
  // Close about the limit of 2 η/k = 0.000917 s, then on to where the sphere is lost.
  return {2e-5,   5e-5, 1e-4,   2e-4,   3e-4,   4e-4,   5e-4,   6e-4,   7e-4,    8e-4,  8.5e-4,
          8.8e-4, 9e-4, 9.1e-4, 9.2e-4, 9.3e-4, 9.5e-4, 9.7e-4, 9.9e-4, 1.05e-3, 1.2e-3};
}

Settled settle_overlap(SteppingEngine& engine, Integrator integrator, double step, double end) {
  const Scene scene = settling_scene(integrator, step, end);
  const double mass = density * std::numbers::pi / 6.0 * std::pow(diameter, 3);
  const double rest = mass * weight / stiffness;
  double worst = 0.0;
  try {
    const auto run = engine.start(scene, {});
    run->advance(static_cast<std::int64_t>(std::llround(end / step)) - last_steps);
    for (int n = 0; n < last_steps; ++n) {
      run->advance(1);
      run->synchronise();
      worst = std::max(worst, std::abs(0.5 * diameter - run->frame().position[0].z() - rest) / rest);
    }
  } catch (const RunWentWrong&) {
    return {worst, true};
  }
  return {worst, false};
}

}  // namespace grainproof::bench
