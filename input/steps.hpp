// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "input/set_up.hpp"

namespace grainproof::input {

/// Seconds of a step as wished; `dither` is added to its steps per contact. `contact` is the scene's
/// shortest contact in s, and none where nothing can touch.
double resolved_step(const StepWish& wish, double dither, const std::optional<double>& contact);

/// A wish by error becomes one in seconds, with the reason; others are left as they are. Refuses laws and
/// integrators whose errors were not measured.
StepWish with_error_resolved(StepWish wish, const Scene& scene, const std::optional<double>& impact_speed);

/// Duration of the shortest contact of a scene, s.
std::optional<double> shortest_contact_of(const SetUp& set_up);

/// Refuses bodies and walls that move so far in a step that a contact could be missed without a trace.
void check_strides(const Scene& scene, double step, const Node& place);

/// Guards the steps of one scene with one integrator.
class StabilityGuard {
 public:
  StabilityGuard(const SetUp& set_up, bool force);

  /// Refuses a step above the limit, unless the scene or --force permits it.
  void check(double step, const Node& place) const;

 private:
  bool open_;
  double limit_ = 0.0;
  std::string because_;
};

/// 0, then as recorded, then `end`.
std::vector<double> sample_times(const RecordWish& wish, double end, double step, const Node& place);

}  // namespace grainproof::input
