// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

/// Walls that move, and bodies that resist rolling, in scenes of turning spheres.
namespace grainproof::opencl::testing {

/// Inside a cylinder that turns, on a floor that shakes, past a pin that moves.
Scene in_a_drum(Scene boxed);

/// Hertz contacts of every memory, with a paddle that goes through a periodic face.
Scene swept_by_a_paddle(Scene periodic);

/// Against a constant torque, on a floor that turns.
Scene rolling_steadily(Scene boxed);

}  // namespace grainproof::opencl::testing
