// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>

#include "model/fields.hpp"

namespace grainproof::reference {

/// Gravity at one moment (docs/laws/fields.md). What is the same everywhere is evaluated once a step.
class GravityField {
 public:
  GravityField(const Gravity& gravity, double time);

  Vec3 at(const Vec3& position) const { return centre_ ? towards_centre(position) : uniform_; }

 private:
  Vec3 towards_centre(const Vec3& position) const;

  Vec3 uniform_ = Vec3::Zero();
  std::optional<CentralGravity> centre_;
};

}  // namespace grainproof::reference
