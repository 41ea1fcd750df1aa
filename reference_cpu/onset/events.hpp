// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "reference_cpu/bodies.hpp"
#include "reference_cpu/encounter.hpp"
#include "reference_cpu/periodic_box.hpp"

namespace grainproof::reference {

/// A contact that began or ended within a step: what acted, less what the plain scheme has acted or will act
/// in its place. All on body 2, and the opposite on body 1.
struct OnsetEvent {
  Encounter meet;
  TorqueArms arms;
  Vec3 push = Vec3::Zero();    ///< along n, N s
  Vec3 rub = Vec3::Zero();     ///< of friction, N s
  Vec3 shift = Vec3::Zero();   ///< of mass times position, kg m
  Vec3 resist = Vec3::Zero();  ///< of rolling resistance, N m s
  Vec3 centre = Vec3::Zero();  ///< of body 2 as the forces were evaluated, m
};

/// Those of one step, in the order in which contacts are summed: beginnings before endings.
class OnsetEvents {
 public:
  void clear() { events_.clear(); }
  void add(const OnsetEvent& event) { events_.push_back(event); }
  bool none() const { return events_.empty(); }
  auto begin() const { return events_.begin(); }
  auto end() const { return events_.end(); }

 private:
  std::vector<OnsetEvent> events_;
};

/// To be done once the step's velocities have settled.
void correct(Bodies& bodies, const PeriodicBox& box, const OnsetEvent& event);

}  // namespace grainproof::reference
