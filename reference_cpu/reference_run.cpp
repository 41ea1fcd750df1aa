// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/reference_run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "model/strides.hpp"
#include "reference_cpu/digest.hpp"
#include "reference_cpu/fields.hpp"
#include "reference_cpu/implicit_dashpots.hpp"
#include "reference_cpu/memories.hpp"
#include "reference_cpu/orientations.hpp"
#include "reference_cpu/origin.hpp"

namespace grainproof::reference {
namespace {

bool within(const Vec3& position, const Domain& domain) {
  return (position.array() >= domain.lower.array()).all() && (position.array() <= domain.upper.array()).all();
}

Bodies inside_bodies(const Scene& scene, const PeriodicBox& box) {
  Bodies bodies = bodies_of(scene);
  for (Body& body : bodies.body) body.position = box.inside(body.position);
  return bodies;
}

}  // namespace

ReferenceRun::ReferenceRun(const Scene& scene, bool with_ledger, const Beginning& beginning)
    : origin_(origin_of(scene)),
      scene_(counted_from(origin_, scene)),
      scheme_(scheme_for(scene_.run.integrator)),
      box_(scene_.domain),
      walls_(scene_),
      laws_(scene_),
      cohesion_(has_cohesion(scene_)),
      simple_(laws_.all_simple()),
      may_leap_(may_leap(scene_)),
      bodies_(inside_bodies(scene_, box_)),
      neighbours_(scene_, walls_, bodies_, box_),
      space_order_(scene_),
      history_(memories_of(scene_)),
      watch_(scene_.run.overlap_limit),
      first_step_(beginning.step),
      step_(first_step_) {
  if (with_ledger) ledger_.emplace(scene_);
  walls_.move_to(static_cast<double>(first_step_) * scene_.run.step);
  if (bodies_.orientation.size() == beginning.orientation.size()) bodies_.orientation = beginning.orientation;
  find_neighbours();
  evaluate_forces(0.0, time());
  if (ledger_) ledger_->begin();
}

void ReferenceRun::advance(std::int64_t steps) {
  if (steps == 0) return;
  raise_trouble();
  const auto began = std::chrono::steady_clock::now();
  for (std::int64_t n = 0; n < steps; ++n) take_step();
  check_velocities();
  step_loop_wall_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

template <class Kick>
void ReferenceRun::kick(Kick apply) {
  if (ledger_) ledger_->before_kick(bodies_);
  const double duration = apply();
  if (ledger_) ledger_->after_kick(bodies_, duration);
}

void ReferenceRun::take_step() {
  if (!scheme_.substeps.empty()) return take_substeps();
  const double step = scene_.run.step;
  kick([&] { return scheme_.move(bodies_, scene_.flow, step, step_ - first_step_); });
  turn_bodies(scene_.orientation, bodies_, step, scheme_.move_lag);
  ++step_;
  confine(step);
  raise_trouble();
  walls_.move_to(time());
  find_neighbours();
  evaluate_forces(step, time());
  if (scheme_.settle) kick([&] { return scheme_.settle(bodies_, step); });
  if (!events_.none()) correct_onsets();
  raise_trouble();
}

void ReferenceRun::take_substeps() {
  const double step = scene_.run.step, lead = scheme_.substeps.front().drift;
  // No force is evaluated at a boundary, so that springs lack the drift that led there.
  double place = 0.0, lacking = step_ > first_step_ ? lead : 0.0;
  ++step_;
  for (const SubStep& part : scheme_.substeps) {
    place += part.drift;
    const double now = (static_cast<double>(step_ - 1) + place) * step;
    drift_on(part.drift * step, now);
    evaluate_forces((lacking + part.drift) * step, now);
    lacking = 0.0;
    grainproof::reference::kick(bodies_, part.kick * step);
  }
  drift_on(lead * step, time());
}

void ReferenceRun::drift_on(double duration, double now) {
  drift(bodies_, duration);
  turn_bodies(scene_.orientation, bodies_, duration, 0.0);
  confine(duration);
  raise_trouble();
  walls_.move_to(now);
  find_neighbours();
}

void ReferenceRun::find_neighbours() {
  if (!neighbours_.outdated(bodies_)) return;
  space_order_.before_list(neighbours_, bodies_, history_, touching_);
  neighbours_.list(bodies_);
}

bool ReferenceRun::leapt(const Body& body, double step) const {
  return may_leap_ && body.velocity.squaredNorm() * (step * step) > body.radius * body.radius;
}

// Comparisons are false for NaN, so one test finds what has left and what is no number any more.
void ReferenceRun::confine(double step) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Vec3& position = bodies_.body[i].position;
    if (leapt(bodies_.body[i], step)) watch_.report({Trouble::Kind::leapt, static_cast<std::int32_t>(i)});
    if (box_.any()) position = box_.inside(position);
    if (within(position, scene_.domain)) continue;
    const auto kind = position.allFinite() ? Trouble::Kind::escaped : Trouble::Kind::not_finite;
    watch_.report({kind, static_cast<std::int32_t>(i)});
  }
}

void ReferenceRun::clear_forces() {
  std::ranges::fill(bodies_.acceleration, Vec3::Zero());
  std::ranges::fill(bodies_.angular_acceleration, Vec3::Zero());
}

void ReferenceRun::evaluate_forces(double elapsed, double now) {
  if (scheme_.foresee) evaluate_springs(elapsed, now);
  ForceLog* log = ledger_ ? &ledger_->log() : nullptr;
  if (log) log->clear();
  clear_forces();
  add_contacts(elapsed, log);
  const bool drag = !scheme_.applies_drag;
  add_fields(scene_, now, {.acts = drag, .implicit_over = scheme_.foresee ? elapsed : 0.0}, bodies_, log);
}

void ReferenceRun::evaluate_springs(double elapsed, double now) {
  clear_forces();
  history_.begin(elapsed);
  add_spring_forces({laws_, box_, walls_, cohesion_, simple_}, neighbours_, bodies_, history_, watch_);
  add_fields(scene_, now, {.acts = false}, bodies_, nullptr);
  if (elapsed > 0.0) scheme_.foresee(bodies_, elapsed);
}

void ReferenceRun::add_contacts(double elapsed, ForceLog* log) {
  const ContactSetting setting{laws_, box_, walls_, cohesion_, simple_};
  const bool corrects = scene_.run.integrator == Integrator::onset_corrected;
  if (scheme_.foresee) {
    history_.begin(0.0);
    add_forces_with_implicit_dashpots(setting, elapsed, neighbours_, bodies_, history_, watch_, log);
  } else if (corrects || (bodies_.predicts() && !simple_)) {
    history_.begin(elapsed);
    touching_.begin();
    add_boundary_forces(setting, {scene_.run.step, elapsed > 0.0, corrects}, neighbours_, bodies_, history_,
                        touching_, watch_, log, events_);
  } else {
    history_.begin(elapsed);
    add_contact_forces(setting, neighbours_, bodies_, history_, watch_, log);
  }
}

void ReferenceRun::book_half_of_onsets() {
  if (!ledger_) return;
  for (const OnsetEvent& event : events_) ledger_->half_of(event, bodies_, walls_, box_);
}

/// All are booked before and after all, so that what each has done does not depend on their order.
void ReferenceRun::correct_onsets() {
  book_half_of_onsets();
  for (const OnsetEvent& event : events_) correct(bodies_, box_, event);
  book_half_of_onsets();
  events_.clear();
}

void ReferenceRun::check_velocities() {
  const auto report = [&](std::size_t i) {
    watch_.report({Trouble::Kind::not_finite, static_cast<std::int32_t>(i)});
  };
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (!bodies_.body[i].velocity.allFinite()) report(i);
  for (std::size_t i = 0; i < bodies_.spin.size(); ++i)
    if (!bodies_.spin[i].angular_velocity.allFinite()) report(i);
  raise_trouble();
}

void ReferenceRun::raise_trouble() const {
  if (!watch_.trouble()) return;
  Trouble trouble = *watch_.trouble();
  trouble.particle = bodies_.origin[trouble.particle];
  if (trouble.kind == Trouble::Kind::pair_too_deep) trouble.partner = bodies_.origin[trouble.partner];
  throw in_words(trouble, scene_, step_, watch_.overlap_limit());
}

std::vector<Vec3> ReferenceRun::positions() const {
  std::vector<Vec3> positions(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    positions[bodies_.origin[i]] = place_of(bodies_.body[i].position, origin_, scene_.domain);
  return positions;
}

Frame ReferenceRun::frame() {
  const Motion synchronised = motion_after(bodies_, velocity_lag() * scene_.run.step);
  return {.step = step_,
          .time = time(),
          .position = positions(),
          .velocity = in_scene_order(bodies_, synchronised.velocity),
          .angular_velocity = in_scene_order(bodies_, synchronised.angular_velocity),
          .orientation = in_scene_order(bodies_, bodies_.orientation)};
}

State ReferenceRun::state() {
  const Motion held = motion_after(bodies_, 0.0);
  State state{.step = step_,
              .time = time(),
              .ids = {},
              .position = positions(),
              .velocity = in_scene_order(bodies_, held.velocity),
              .angular_velocity = in_scene_order(bodies_, held.angular_velocity),
              .orientation = in_scene_order(bodies_, bodies_.orientation),
              .velocity_lag = velocity_lag(),
              .contacts = memories_by_id(scene_, history_, bodies_)};
  for (const Particle& particle : scene_.particles) state.ids.push_back(particle.id);
  return state;
}

std::uint64_t ReferenceRun::digest() {
  return digest_of(state());
}

Counters ReferenceRun::counters() const {
  return {.steps = step_,
          .list_rebuilds = neighbours_.rebuilds(),
          .listed_pairs = static_cast<std::int64_t>(neighbours_.pairs().size()),
          .step_loop_wall_s = step_loop_wall_s_};
}

Ledger ReferenceRun::ledger() {
  return ledger_ ? ledger_->at(bodies_, velocity_lag() * scene_.run.step) : Ledger{};
}

}  // namespace grainproof::reference
