// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/invariants.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/metrics/mass.hpp"

namespace grainproof {
namespace {

constexpr const char* no_ledger = "the engine gave no ledger";

/// Σ m v, and Σ m |v| as its scale, over the moving particles.
struct Momentum {
  Vec3 sum = Vec3::Zero();
  double scale = 0.0;
};

Momentum momentum(const Scene& scene, const Frame& frame) {
  Momentum total;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    const Vec3 own = mass_of(scene, scene.particles[i]) * frame.velocity[i];
    total.sum += own;
    total.scale += own.norm();
  }
  return total;
}

double largest_entry(const Ledger& ledger) {
  return std::max({std::abs(ledger.kinetic), std::abs(ledger.elastic), std::abs(ledger.cohesive),
                   std::abs(ledger.gravity_work), std::abs(ledger.drag_work),
                   std::abs(ledger.dissipated_normal), std::abs(ledger.dissipated_tangential)});
}

bool inside(const Domain& domain, const Vec3& x) {
  for (int axis = 0; axis < 3; ++axis)
    if (!domain.periodic(axis) && !(x[axis] >= domain.lower[axis] && x[axis] <= domain.upper[axis]))
      return false;
  return x.allFinite();
}

Measured relative(double error, double scale) {
  if (scale == 0.0 && error == 0.0) return Measured::of(0.0);
  return Measured::of(error / scale);
}

}  // namespace

Measured momentum_error(const Scene& scene, const Observations& seen, const Observations&) {
  if (!seen.initial_ledger || !seen.final_ledger) return Measured::none(no_ledger);
  const Vec3 support = seen.final_ledger->support_impulse - seen.initial_ledger->support_impulse;
  const Vec3 field = seen.final_ledger->field_impulse - seen.initial_ledger->field_impulse;
  const Vec3 change = momentum(scene, seen.frames.back()).sum - momentum(scene, seen.frames.front()).sum;
  double scale = 0.0;
  for (const Frame& frame : seen.frames) scale = std::max(scale, momentum(scene, frame).scale);
  return relative((change - support - field).norm(), scale + support.norm() + field.norm());
}

Measured energy_error(const Scene&, const Observations& seen, const Observations&) {
  if (!seen.initial_ledger || !seen.final_ledger) return Measured::none(no_ledger);
  const double scale = std::max(largest_entry(*seen.initial_ledger), largest_entry(*seen.final_ledger));
  return relative(seen.final_ledger->balance() - seen.initial_ledger->balance(), scale);
}

Measured lost_particles(const Scene& scene, const Observations& seen, const Observations&) {
  std::size_t most = 0;
  for (const Frame& frame : seen.frames) {
    const auto kept = std::count_if(frame.position.begin(), frame.position.end(),
                                    [&](const Vec3& x) { return inside(scene.domain, x); });
    most = std::max(most, scene.particles.size() - static_cast<std::size_t>(kept));
  }
  return Measured::of(static_cast<double>(most) / static_cast<double>(scene.particles.size()));
}

}  // namespace grainproof
