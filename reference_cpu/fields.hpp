// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/force_log.hpp"

namespace grainproof::reference {

/// Turns the summed contact forces and torques into accelerations and adds gravity and, unless the integrator
/// applies it by itself, drag. Fixed particles get none. `log` may be null.
void add_fields(const Scene& scene, double time, bool with_drag, Bodies& bodies, ForceLog* log);

}  // namespace grainproof::reference
