// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <vector>

#include "analytic/encounter.hpp"
#include "analytic/linear_motion.hpp"

namespace grainproof::analytic {

/// What acts along the normal (linear.1, cohesion.1).
enum class Regime {
  apart,      ///< gravity alone
  attracted,  ///< effect surfaces overlap, bodies do not
  pressed,    ///< bodies overlap
  released,   ///< bodies overlap, but the clamped force is zero (`no_tension`)
};

struct Phase {
  double from;  ///< s
  Regime regime;
  LinearMotion motion;  ///< of the gap, from `from` on
};

/// How much of a motion is followed.
enum class Extent { until_the_end, through_first_contact };

/// Motion of the gap: exact within a phase, the phases joined where an event's root says.
class Passage {
 public:
  /// Throws EngineFailed when `until` holds more than a hundred thousand phases.
  Passage(const Encounter& encounter, double until, Extent extent = Extent::until_the_end);

  Motion at(double time) const;
  const std::vector<Phase>& phases() const { return phases_; }

  /// One stay in body contact, from gap 0 to gap 0, forceless parting included.
  struct Contact {
    double onset;                    ///< s; the start where it begins in contact
    double entry_speed;              ///< inward, m/s
    double peak_overlap;             ///< m
    std::optional<double> end;       ///< s; none where it lasts beyond the end
    std::optional<double> released;  ///< s; with `no_tension`, when the force first falls to zero
    double exit_speed = 0.0;         ///< outward, m/s
  };

  /// None where the bodies never touch.
  std::optional<Contact> first_contact() const;

 private:
  std::vector<Phase> phases_;
};

}  // namespace grainproof::analytic
