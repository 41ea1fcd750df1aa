// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/contact_errors.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/contact_scales.hpp"
#include "benchmarks/common/exact_solution.hpp"
#include "benchmarks/common/scenes.hpp"
#include "model/errors.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::bench {
namespace {

using analytic::ErrorLaw;

constexpr double until_parted = 4.0;   // contacts
constexpr double usual_speed = 1.0;    // m/s, that a Hertz contact's duration is taken at
constexpr int finer_than_finest = 32;  // a solution's own error is then 3 % of the least that is measured

bool is_hertz(ErrorLaw law) {
  return law == ErrorLaw::hertz || law == ErrorLaw::hertz_history;
}

PairGas gas_of(ErrorLaw law, double of_restitution) {
  const bool history = law == ErrorLaw::linear_history || law == ErrorLaw::hertz_history;
  return {.name = std::string(name_of(law)) + std::to_string(of_restitution),
          .pairs = history ? 100 : 400,  // a fine solution costs more
          .restitution = of_restitution,
          .hertz = is_hertz(law),
          .oblique = history,
          .spread = 0.05,
          .counted_in = 1.0};
}

/// Of two spheres of the usual size, as the scene's shortest contact is found for a step.
double usual_duration(const PairGas& gas) {
  PairGas alike = gas;
  alike.pairs = 1;
  alike.spread = 0.0;
  return analytic::shortest_contact(pair_scene(alike, 1.0), usual_speed)->duration;
}

Scene contacts(const PairGas& gas, bool no_tension, double steps_per_contact) {
  Scene scene = pair_scene(gas, steps_per_contact);
  const double duration = usual_duration(gas);
  scene.run.step = duration / steps_per_contact;
  scene.run.end = until_parted * duration;
  scene.run.sample_times = {0.0, scene.run.end};
  if (!no_tension) return scene;
  ContactLaws laws = scene.contacts.at(0, 0);
  std::get<LinearNormal>(laws.normal).no_tension = true;
  scene.contacts.set(0, 0, laws);
  return scene;
}

/// One sphere that a still fluid stops, after one relaxation time.
Scene relaxing(double steps) {
  Scene scene = empty_scene(Vec3::Constant(10.0 * diameter));
  scene.domain.boundary = {Boundary::open, Boundary::open, Boundary::open};
  scene.rotation = false;
  scene.flow = UniformFlow{pair_viscosity(), Vec3::Zero()};
  scene.run.end = density * diameter * diameter / (18.0 * pair_viscosity());
  scene.run.step = scene.run.end / steps;
  scene.run.sample_times = {0.0, scene.run.end};
  scene.particles.push_back(
      {1, 0, false, diameter, diameter, Vec3::Constant(5.0 * diameter), Vec3(1.0, 0.0, 0.0)});
  return scene;
}

std::vector<Vec3> end_of(Scene scene, Integrator integrator) {
  reference::ReferenceEngine engine;
  scene.run.integrator = integrator;
  return step_through(engine, scene, steps_of(scene)).velocity;
}

double drag_error(Integrator integrator, double steps) {
  return std::abs(end_of(relaxing(steps), integrator).front().x() - std::exp(-1.0));
}

double error_in(const AccuracyScene& of, Integrator integrator, double steps) {
  const Scene scene = of.make(steps);
  const std::vector<Vec3> start = relative_velocities(velocities_of(scene));
  const std::vector<Vec3> end = relative_velocities(end_of(scene, integrator));
  if (of.gas->closed_form())
    return rms_error(end, rebounds(scene, std::vector<double>(start.size(), of.gas->restitution)), start);
  return rms_error(end, fine_solution(of, Variant::ours_and_lammps).velocity, start);
}

AccuracyScene scene_of(ErrorLaw law, double of_restitution) {
  const PairGas gas = gas_of(law, of_restitution);
  const bool no_tension = law == ErrorLaw::no_tension;
  return {.name = gas.name,
          .make = [gas, no_tension](double steps) { return contacts(gas, no_tension, steps); },
          .steps_per_contact = {analytic::measured_at.begin(), analytic::measured_at.end()},
          .gas = gas,
          .finer = finer_than_finest};
}

}  // namespace

double contact_error(ErrorLaw law, Integrator integrator, double of_restitution, double steps) {
  try {
    const double error = law == ErrorLaw::drag ? drag_error(integrator, steps)
                                               : error_in(scene_of(law, of_restitution), integrator, steps);
    return error < 1.0 ? error : 1.0;
  } catch (const RunWentWrong&) {
    return 1.0;
  }
}

bool can_be_measured(ErrorLaw law, Integrator integrator) {
  Scene scene = law == ErrorLaw::drag ? relaxing(8.0) : scene_of(law, 0.8).make(8.0);
  scene.run.integrator = integrator;
  return reference::ReferenceEngine().supports(scene, {}).yes;
}

}  // namespace grainproof::bench
