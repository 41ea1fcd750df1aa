// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::reference {

/// Overlap of two bodies, m, and its rate, m/s, positive while they approach.
struct NormalState {
  double overlap;
  double rate;
};

/// Exact motion of two bodies under nothing but the linear spring and dashpot between them,
/// m δ'' = −k δ − η δ' (docs/laws/integrators.md).
class DampedFlow {
 public:
  DampedFlow(double stiffness, double damping, double mass);

  NormalState after(const NormalState& start, double time) const;

  /// When the overlap falls to 0, s; infinity where it never does.
  double time_to_part(const NormalState& start) const;

  double mass() const { return mass_; }

 private:
  enum class Kind { vibrates, critical, creeps };

  double mass_;
  double decay_;   ///< b = η/(2m), 1/s
  double square_;  ///< k/m, 1/s²
  double rate_;    ///< sqrt(|k/m − b²|), 1/s
  Kind kind_;
};

}  // namespace grainproof::reference
