// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/fields.hpp"

namespace grainproof::reference {

/// Velocity of the fluid at a point, m/s (docs/laws/fields.md). Zero without a fluid.
Vec3 fluid_velocity(const Flow& flow, const Vec3& position);

}  // namespace grainproof::reference
