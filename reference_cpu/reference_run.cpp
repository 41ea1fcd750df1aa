// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/reference_run.hpp"

#include <algorithm>
#include <chrono>

#include "reference_cpu/digest.hpp"
#include "reference_cpu/fields.hpp"

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

ReferenceRun::ReferenceRun(const Scene& scene, bool with_ledger)
    : scene_(scene),
      scheme_(scheme_for(scene_.run.integrator)),
      box_(scene_.domain),
      laws_(scene_.contacts, scene_.run.step),
      cohesion_(has_cohesion(scene_)),
      bodies_(inside_bodies(scene_, box_)),
      neighbours_(scene_, bodies_, box_),
      watch_(scene_.run.overlap_limit) {
  if (with_ledger) ledger_.emplace(scene_);
  evaluate_forces();
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
  const double step = scene_.run.step;
  kick([&] { return scheme_.move(bodies_, scene_.flow, step, step_); });
  ++step_;
  confine();
  raise_trouble();
  neighbours_.update(bodies_);
  evaluate_forces();
  if (scheme_.settle) kick([&] { return scheme_.settle(bodies_, step); });
  raise_trouble();
}

// Comparisons are false for NaN, so one test finds what has left and what is no number any more.
void ReferenceRun::confine() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    Vec3& position = bodies_.body[i].position;
    if (box_.any()) position = box_.inside(position);
    if (within(position, scene_.domain)) continue;
    const auto kind = position.allFinite() ? Trouble::Kind::escaped : Trouble::Kind::not_finite;
    watch_.report({kind, static_cast<std::int32_t>(i)});
  }
}

void ReferenceRun::evaluate_forces() {
  ForceLog* log = ledger_ ? &ledger_->log() : nullptr;
  if (log) log->clear();
  std::ranges::fill(bodies_.acceleration, Vec3::Zero());
  add_contact_forces({laws_, box_, scene_.walls, cohesion_}, neighbours_, bodies_, watch_, log);
  add_fields(scene_, time(), !scheme_.applies_drag, bodies_, log);
}

void ReferenceRun::check_velocities() {
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    if (!bodies_.body[i].velocity.allFinite())
      watch_.report({Trouble::Kind::not_finite, static_cast<std::int32_t>(i)});
  raise_trouble();
}

void ReferenceRun::raise_trouble() const {
  if (watch_.trouble()) throw in_words(*watch_.trouble(), scene_, step_, watch_.overlap_limit());
}

Frame ReferenceRun::frame() {
  Frame frame;
  frame.step = step_;
  frame.time = time();
  const double pending = velocity_lag() * scene_.run.step;
  frame.position.reserve(bodies_.size());
  frame.velocity.reserve(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    frame.position.push_back(bodies_.body[i].position);
    frame.velocity.push_back(bodies_.body[i].velocity + bodies_.acceleration[i] * pending);
  }
  return frame;
}

State ReferenceRun::state() {
  State state;
  state.step = step_;
  state.time = time();
  state.ids = bodies_.id;
  state.velocity_lag = velocity_lag();
  state.position.reserve(bodies_.size());
  state.velocity.reserve(bodies_.size());
  for (const Body& body : bodies_.body) {
    state.position.push_back(body.position);
    state.velocity.push_back(body.velocity);
  }
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
