// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/turning.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace grainproof {
namespace {

Measured size_of(const Observations& seen, std::size_t wall, std::vector<Vec3> Ledger::*impulses) {
  if (!seen.final_ledger) return Measured::none("the engine gave no ledger");
  const std::vector<Vec3>& all = (*seen.final_ledger).*impulses;
  if (wall >= all.size()) return Measured::none("the ledger has no wall " + std::to_string(wall));
  return Measured::of(all[wall].norm());
}

/// q and −q are the same turn; the length does not count.
double angle_between(const Quaternion& a, const Quaternion& b) {
  const Quaternion apart = a.conjugate() * b;
  return 2.0 * std::atan2(apart.vec().norm(), std::abs(apart.w()));
}

}  // namespace

Measured final_spin(const Scene& scene, const Observations& seen) {
  const std::vector<Vec3>& spins = seen.frames.back().angular_velocity;
  for (std::size_t i = 0; i < spins.size(); ++i)
    if (!scene.particles[i].fixed) return Measured::of(spins[i].norm());
  return Measured::none("there are no angular velocities; is `rotation` on?");
}

Measured orientation_error(const Scene&, const Observations& seen, const Observations& exact) {
  if (seen.frames.size() != exact.frames.size()) return Measured::none("the frames do not correspond");
  double largest = 0.0;
  for (std::size_t k = 0; k < seen.frames.size(); ++k) {
    const std::vector<Quaternion>& own = seen.frames[k].orientation;
    const std::vector<Quaternion>& right = exact.frames[k].orientation;
    if (own.empty() || own.size() != right.size())
      return Measured::none("there are no orientations; is `bodies.orientation` on?");
    for (std::size_t i = 0; i < own.size(); ++i) {
      const double angle = angle_between(right[i], own[i]);
      if (!std::isfinite(angle)) return Measured::of(angle);
      largest = std::max(largest, angle);
    }
  }
  return Measured::of(largest);
}

Measured wall_impulse_of(const Observations& seen, std::size_t wall) {
  return size_of(seen, wall, &Ledger::wall_impulses);
}

Measured wall_angular_impulse_of(const Observations& seen, std::size_t wall) {
  return size_of(seen, wall, &Ledger::wall_angular_impulses);
}

Measured wall_work(const Scene&, const Observations& seen) {
  if (!seen.final_ledger) return Measured::none("the engine gave no ledger");
  return Measured::of(seen.final_ledger->wall_work);
}

}  // namespace grainproof
