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

/// A contact whose overlap and its rate are changed by this one only: `point` says all but these two.
class PartialContact {
 public:
  PartialContact(const PairLaws& laws, const ContactPoint& point, double step)
      : laws_(laws), point_(point), root_mass_(std::sqrt(point.effective_mass)), step_(step) {}

  /// From the overlap at the step's end and the half-step rate that led there.
  Beginning beginning(const NormalState& reached) const;

  /// From the overlap before the step, not below zero, and its rate then.
  PartialPush ending(const NormalState& left) const;

  /// Spring and dashpot without a look at no_tension; positive pushes.
  double force_at(const NormalState& state) const;

  bool hertz() const { return laws_.hertz.present(); }

 private:
  ContactResponse response_at(const NormalState& state) const;
  DampedFlow flow() const;
  double time_left(const NormalState& left) const;
  double mean_magnitude(const NormalState& left, double time) const;
  Beginning hertz_beginning(const NormalState& reached, double lasted) const;
  PartialPush hertz_ending(const NormalState& left) const;

  const PairLaws& laws_;
  const ContactPoint& point_;
  double root_mass_, step_;
};

/// How far a Hertz contact's springs and dashpots against slip are, over the time in contact, from those at
/// `point`. Ones for a linear contact.
struct ShearShare {
  double stiffness = 1.0, damping = 1.0;
};
inline constexpr ShearShare hertz_shear_of_a_beginning{0.8, 0.8}, hertz_shear_of_an_ending{2.0 / 3.0, 0.8};

/// What friction does to body 2 over that time, N s. `spring` is where it stood at its start.
Vec3 friction_impulse(const PairLaws& laws, const ContactPoint& point, const Vec3& slip, const Vec3& spring,
                      const PartialPush& push, const ShearShare& share);

/// Of friction whose spring and dashpot together go evenly from `first` to `last`, against them, as far as a
/// limit lets them that goes evenly from `most_first` to `most_last` (integrators.21).
Vec3 limited_impulse(const Vec3& first, const Vec3& last, double most_first, double most_last, double time);

}  // namespace grainproof::reference
