// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/scene.hpp"

namespace grainproof::reference {

/// Periodic faces of the domain. Along other axes nothing is ever shifted.
class PeriodicBox {
 public:
  explicit PeriodicBox(const Domain& domain) : lower_(domain.lower), upper_(domain.upper) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain.periodic(axis)) continue;
      any_ = true;
      period_[axis] = upper_[axis] - lower_[axis];
      half_[axis] = 0.5 * period_[axis];
      smallest_half_ = std::min(smallest_half_, half_[axis]);
    }
  }

  bool any() const { return any_; }
  bool periodic(int axis) const { return period_[axis] > 0.0; }
  const Vec3& lower() const { return lower_; }
  const Vec3& upper() const { return upper_; }

  /// Of the difference of two positions inside the box, the shortest among the images.
  Vec3 nearest_image(Vec3 apart) const {
    if (apart.squaredNorm() < smallest_half_ * smallest_half_) return apart;  // as nearly always
    for (int axis = 0; axis < 3; ++axis) {
      if (apart[axis] > half_[axis])
        apart[axis] -= period_[axis];
      else if (apart[axis] < -half_[axis])
        apart[axis] += period_[axis];
    }
    return apart;
  }

  /// The image inside [lower, upper) along periodic axes.
  Vec3 inside(Vec3 position) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!periodic(axis)) continue;
      double& x = position[axis];
      if (x >= lower_[axis] && x < upper_[axis]) continue;
      x -= period_[axis] * std::floor((x - lower_[axis]) / period_[axis]);
      if (x >= upper_[axis] || x < lower_[axis]) x = lower_[axis];  // a last digit beyond the face
    }
    return position;
  }

 private:
  bool any_ = false;
  Vec3 lower_, upper_;
  Vec3 period_ = Vec3::Zero();
  double smallest_half_ = std::numeric_limits<double>::infinity();
  Vec3 half_ = Vec3::Constant(std::numeric_limits<double>::infinity());
};

}  // namespace grainproof::reference
