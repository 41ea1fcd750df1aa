// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/exact_solution.hpp"

#include <algorithm>
#include <chrono>
#include <map>

#include "reference_cpu/reference_engine.hpp"

namespace grainproof::bench {
namespace {

using Clock = std::chrono::steady_clock;

Scene with_variant(Scene scene, Variant variant) {
  ContactLaws laws = scene.contacts.at(0, 0);
  auto* friction = std::get_if<HistoryFriction>(&laws.friction);
  if (variant == Variant::ours_and_lammps || friction == nullptr) return scene;
  friction->limit = CoulombLimit::spring;
  friction->arm = TorqueArm::overlap;
  scene.contacts.set(0, 0, laws);
  return scene;
}

Integrator most_accurate(const reference::ReferenceEngine& engine, Scene scene) {
  for (const char* name : {"onset_corrected", "velocity_verlet"}) {
    scene.run.integrator = integrator_named(name).value_or(Integrator::velocity_verlet);
    const Integrator integrator = scene.run.integrator;
    if (engine.supports(scene, {})) return integrator;
  }
  return Integrator::velocity_verlet;
}

std::vector<Vec3> solution_at(const AccuracyScene& scene, Variant variant, double steps_per_contact) {
  reference::ReferenceEngine engine;
  Scene fine = with_variant(scene.make(steps_per_contact), variant);
  fine.run.integrator = most_accurate(engine, fine);
  return compared(scene, step_through(engine, fine, steps_of(fine)).velocity);
}

}  // namespace

Stepped step_through(SteppingEngine& engine, const Scene& scene, std::int64_t steps) {
  const auto run = engine.start(scene, {});
  const auto began = Clock::now();
  run->advance(steps);
  run->synchronise();
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  return {run->frame().velocity, seconds};
}

const Exact& fine_solution(const AccuracyScene& scene, Variant variant) {
  static std::map<std::pair<std::string, Variant>, Exact> known;
  Exact& exact = known[{scene.name, variant}];
  if (!exact.velocity.empty()) return exact;
  const double ratio =
      scene.finer * *std::max_element(scene.steps_per_contact.begin(), scene.steps_per_contact.end());
  exact.velocity = solution_at(scene, variant, ratio);
  exact.uncertainty = scene_error(scene, solution_at(scene, variant, 0.5 * ratio), exact.velocity,
                                  compared(scene, velocities_of(scene.make(1.0))));
  return exact;
}

}  // namespace grainproof::bench
