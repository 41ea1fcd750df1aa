// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/energy_sentinel.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/contact_scales.hpp"
#include "model/errors.hpp"
#include "report/energies.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

/// Sums of single precision over all that has been turned over since the start are no better known.
constexpr double noise = 1e-4;

double mass_of(const Scene& scene, const Particle& particle) {
  return analytic::sphere_mass(scene.materials[static_cast<std::size_t>(particle.material)].density,
                               particle.diameter);
}

double kinetic_of(const Scene& scene, const Frame& frame) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) sum += report::kinetic_energy(scene, frame, i);
  return sum;
}

/// Of constant gravity between two frames; along periodic axes by the nearest image.
double gravity_work(const Scene& scene, const Frame& from, const Frame& to) {
  const Vec3& g = std::get<ConstantGravity>(scene.gravity).acceleration;
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    Vec3 path = to.position[i] - from.position[i];
    for (int axis = 0; axis < 3; ++axis)
      if (scene.domain.periodic(axis) && g[axis] != 0.0)
        path[axis] = std::max(from.velocity[i].norm(), to.velocity[i].norm()) * (to.time - from.time);
    sum += mass_of(scene, scene.particles[i]) * g.dot(path);
  }
  return std::abs(sum);
}

/// One, and the most that friction lets tangential springs hold beside the normal one.
double normal_and_tangential(const ContactLaws& laws) {
  const auto* history = std::get_if<HistoryFriction>(&laws.friction);
  if (history == nullptr) return 1.0;
  const auto* linear = std::get_if<LinearNormal>(&laws.normal);
  return linear == nullptr
             ? 2.0
             : 1.0 + history->coefficient * history->coefficient * linear->stiffness / history->stiffness;
}

bool sources_are_told_by_positions(const Scene& scene) {
  bool told =
      std::holds_alternative<ConstantGravity>(scene.gravity) && std::holds_alternative<NoFlow>(scene.flow);
  for (const Wall& wall : scene.walls) told = told && std::holds_alternative<Still>(wall.motion);
  for (std::size_t a = 0; a < scene.contacts.materials(); ++a)
    for (std::size_t b = 0; b < scene.contacts.materials(); ++b)
      if (scene.contacts.has(a, b))
        told = told && std::holds_alternative<NoCohesion>(scene.contacts.at(a, b).cohesion);
  return told;
}

double turned_over(const Ledger& from, const Ledger& to) {
  return std::abs(to.gravity_work - from.gravity_work) + std::abs(to.drag_work - from.drag_work) +
         std::abs(to.wall_work - from.wall_work) + std::abs(to.cohesive - from.cohesive);
}

/// A dashpot or friction that gives energy is no source.
double given_back(const Ledger& from, const Ledger& to) {
  double sum = 0.0;
  for (const auto lost :
       {&Ledger::dissipated_normal, &Ledger::dissipated_tangential, &Ledger::dissipated_rolling})
    sum += std::max(0.0, from.*lost - to.*lost);
  return sum;
}

double since_the_start(const Ledger& l) {
  return l.kinetic + l.elastic + std::abs(l.gravity_work) + std::abs(l.drag_work) + std::abs(l.wall_work) +
         std::abs(l.dissipated_normal) + std::abs(l.dissipated_tangential) + std::abs(l.dissipated_rolling);
}

}  // namespace

EnergySentinel::EnergySentinel(const Scene& scene)
    : scene_(scene), told_by_positions_(sources_are_told_by_positions(scene)) {}

void EnergySentinel::look(const Frame& frame, const Ledger* ledger) {
  if (ledger != nullptr)
    look_with(frame, *ledger);
  else if (told_by_positions_)
    look_without(frame);
}

void EnergySentinel::look_with(const Frame& frame, const Ledger& now) {
  if (ledger_) {
    const Ledger& then = *ledger_;
    const double gained = now.balance() - then.balance() + given_back(then, now);
    const double allowed =
        limit * (then.kinetic + then.elastic + turned_over(then, now)) + noise * since_the_start(then);
    if (now.kinetic > then.kinetic && gained > allowed)
      tell(frame, then.kinetic, now.kinetic, gained, allowed);
  }
  frame_ = frame;
  ledger_ = now;
}

void EnergySentinel::look_without(const Frame& frame) {
  const double now = kinetic_of(scene_, frame);
  if (frame_) {
    const double then = kinetic_of(scene_, *frame_), fallen = gravity_work(scene_, *frame_, frame);
    const double gained = now - then - fallen;
    // The overlaps are looked at only where they matter: that costs as much as tens of steps.
    if (gained > limit * (then + fallen)) {
      const double held = report::energy_of_overlaps(scene_, *frame_, normal_and_tangential);
      if (gained - held > limit * (then + fallen + held))
        tell(frame, then, now, gained - held, limit * (then + fallen + held));
    }
  }
  frame_ = frame;
}

void EnergySentinel::tell(const Frame& frame, double before, double now, double gained,
                          double allowed) const {
  std::size_t fastest = 0;
  for (std::size_t i = 1; i < scene_.particles.size(); ++i)
    if (report::kinetic_energy(scene_, frame, i) > report::kinetic_energy(scene_, frame, fastest))
      fastest = i;
  std::string text =
      "kinetic energy has risen from " + report::brief(before) + " J at step " +
      std::to_string(frame_->step) + " to " + report::brief(now) + " J, and " + report::brief(gained) +
      " J of that came from no source: gravity, walls, fluid and springs together may account for " +
      "no more than " + report::brief(allowed) + " J of error; particle " +
      std::to_string(scene_.particles[fastest].id) + " has most of it; the likely cause is a step " +
      "too large for this stiffness: the step is " + report::brief(scene_.run.step) + " s";
  if (const auto contact = analytic::shortest_contact(scene_))
    text += ", the shortest contact takes " + report::brief(contact->duration) + " s";
  throw RunWentWrong(text, frame.step, frame.time, {scene_.particles[fastest].id});
}

}  // namespace grainproof::app
