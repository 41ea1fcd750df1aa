// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/force_log.hpp"

namespace grainproof::reference {

struct DragSetting {
  bool acts = true;            ///< unless the integrator applies it by itself
  double implicit_over = 0.0;  ///< s; takes what it leaves of the velocity in half of that
};

/// Turns the summed contact forces and torques into accelerations and adds gravity and drag. Fixed particles
/// get none. `log` may be null.
void add_fields(const Scene& scene, double time, const DragSetting& drag, Bodies& bodies, ForceLog* log);

}  // namespace grainproof::reference
