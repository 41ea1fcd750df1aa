// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "analytic/spectral_limit.hpp"
#include "model/engine.hpp"

/// Measures the largest step at which an engine keeps a scene at rest at rest: docs/stability.md.
namespace grainproof::bench {

/// What the linearised step of an integrator says of a scene.
class Prediction {
 public:
  /// `scene` at rest, and kept by the caller; the integrator by name, since it may be one that is known to
  /// some engine only.
  Prediction(const Scene& scene, std::string_view integrator);

  /// Largest stable step, s; 0 where there is none.
  double limit() const { return limit_; }
  /// Factor by which the fastest motion grows a step.
  double growth(double step) const;

 private:
  std::vector<analytic::LinearSystem> parts(double step) const;

  const Scene& scene_;
  const analytic::LinearScheme& scheme_;
  bool by_step_;                               ///< whether dashpots or drags depend on the step
  std::vector<analytic::LinearSystem> parts_;  ///< where they don't
  double limit_;
};

/// `scene` moved off its rest by `size` (m) in every direction, with velocities to match.
Scene perturbed(const Scene& scene, double size);

struct MeasuredLimit {
  double stable, unstable;  ///< s: the largest step that was found stable, the smallest that was not
  double contact_times;     ///< that a run had to stay bounded for
  int runs;

  double step() const { return 0.5 * (stable + unstable); }
  /// How far the farther of both is from a predicted limit, as a share of it.
  double farthest_from(double predicted) const;
};

/// A run is stable where its kinetic energy never exceeds 10⁴ times what it started with; it lasts 200
/// contact times, and longer where half a percent above the predicted limit needs longer to be seen, up to
/// `most_steps`. Half a percent to either side of the prediction are tried first, and that is all where the
/// limit is between them; else it is searched for. Throws EngineFailed where the engine gives no limit within
/// a factor of 16 of the predicted one.
MeasuredLimit measured_limit(SteppingEngine& engine, const Scene& scene, const Prediction& prediction,
                             std::int64_t most_steps);

/// ln of the factor that the velocities grow by a step, once what grows fastest is by far the largest.
double measured_growth(SteppingEngine& engine, const Scene& scene, double step, double predicted_growth);

}  // namespace grainproof::bench
