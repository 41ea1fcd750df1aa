// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"
#include "reference_cpu/bodies.hpp"

namespace grainproof::reference {

/// Turns every body by one step (s) of the angular velocity that was held `lag` steps ago, as positions
/// are moved (docs/laws/rotation.md). Nothing where the scene asks for no orientations.
void turn_bodies(OrientationUpdate update, Bodies& bodies, double step, double lag);

}  // namespace grainproof::reference
