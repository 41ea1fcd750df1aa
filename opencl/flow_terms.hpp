// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

namespace grainproof::opencl {

/// One beyond the last term of the power series of a contact's motion over a step, kernels/dense_flow.cl,
/// that is above `last_digit` of what the motion is bent by; of the lightest pair and the stiffest law.
int flow_terms(const Scene& scene, double last_digit);

}  // namespace grainproof::opencl
