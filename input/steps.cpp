// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/steps.hpp"

#include <cmath>

#include "analytic/contact_scales.hpp"
#include "analytic/step_for_error.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

/// A run of more steps is a mistake of units: no machine finishes it.
constexpr double most_steps = 1e15;
constexpr double most_frames = 1e6;

}  // namespace

std::optional<double> shortest_contact_of(const SetUp& set_up) {
  const auto shortest = analytic::shortest_contact(set_up.scene, set_up.impact_speed);
  return shortest ? std::optional(shortest->duration) : std::nullopt;
}

StepWish with_error_resolved(StepWish wish, const Scene& scene, const std::optional<double>& impact_speed) {
  if (wish.error == 0.0) return wish;
  const analytic::StepForError choice = analytic::step_for_error(scene, wish.error, impact_speed);
  if (!choice.lacks.empty())
    wish.place.refuse("a step by its error", "another way to give it, since " + choice.lacks);
  wish.seconds = choice.step;
  wish.because = choice.because;
  return wish;
}

double resolved_step(const StepWish& wish, double dither, const std::optional<double>& contact) {
  if (wish.seconds > 0.0) return wish.seconds;
  if (!contact) wish.place.refuse("seconds, since nothing in this scene can touch");
  const double step = *contact / (wish.steps_per_contact + dither);
  if (!(step > 0.0 && std::isfinite(step)))
    wish.place.refuse("a contact of " + shortest(*contact) + " s", "one that a step can resolve");
  return step;
}

StabilityGuard::StabilityGuard(const SetUp& set_up, bool force) : open_(force || set_up.beyond_stability) {
  if (open_) return;
  const analytic::StepLimit limit = analytic::stability_limit(set_up.scene, set_up.impact_speed);
  limit_ = limit.step;
  because_ = limit.because;
}

void StabilityGuard::check(double step, const Node& place) const {
  if (open_ || step <= limit_) return;
  const std::string limit =
      limit_ > 0.0 ? "at most " + shortest(limit_) + " s" : "another integrator, since no step is stable";
  place.refuse("a step of " + shortest(step) + " s above the stability limit",
               limit + " (" + because_ + "); run.beyond_stability = true or --force permits it");
}

std::vector<double> sample_times(const RecordWish& wish, double end, double step, const Node& place) {
  if (!(end / step <= most_steps)) place.refuse("a run of " + shortest(end / step) + " steps", "up to 1e15");
  double interval = wish.amount;
  if (wish.kind == RecordWish::Kind::steps) interval = wish.amount * step;
  if (wish.kind == RecordWish::Kind::frames) interval = end / wish.amount;
  if (!(end / interval <= most_frames)) place.refuse("more than a million frames", "a longer run.record");
  std::vector<double> times;
  for (std::size_t i = 0; static_cast<double>(i) * interval < end * (1.0 - 1e-9); ++i)
    times.push_back(static_cast<double>(i) * interval);
  times.push_back(end);
  return times;
}

}  // namespace grainproof::input
