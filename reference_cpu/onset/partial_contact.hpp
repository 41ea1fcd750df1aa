// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/contact_force.hpp"
#include "reference_cpu/onset/damped_flow.hpp"

/// What a contact does that lasted for a part of a step only (docs/laws/integrators.md).
namespace grainproof::reference {

/// On body 2 along n over the time in contact.
struct PartialPush {
  double lasted;          ///< s
  double impulse;         ///< N s
  double moment;          ///< N s², what the push adds to mass times position by the step's end
  double mean_magnitude;  ///< of the force while it lasted, N
};

/// Where a contact stands at the end of the step in which it began.
struct Beginning {
  NormalState state;
  PartialPush push;
};

/// From the overlap at the step's end and the half-step rate that led there.
Beginning beginning(const PairLaws& laws, const NormalState& reached, double mass, double step);

/// From the overlap before the step, not below zero, and its rate then.
PartialPush ending(const PairLaws& laws, const NormalState& left, double mass, double step);

/// What friction does to body 2 over that time, N s. `spring` is where it stood at its start.
Vec3 friction_impulse(const PairLaws& laws, const ContactPoint& point, const Vec3& slip, const Vec3& spring,
                      const PartialPush& push);

}  // namespace grainproof::reference
