// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/engine.hpp"
#include "opencl/precision.hpp"

namespace grainproof::opencl {

/// What no device can be asked for: a pair without laws, periodic boxes thinner than two reaches,
/// particles outside the domain, bodies larger than it in single precision.
Support within_limits(const Scene& scene, Precision precision);

/// Of integrators that evaluate forces several times on the way of a step.
Support composition_within_limits(const Scene& scene, const Request& request, bool small);

/// Of one wall, and of one contact that remembers at the start.
Support wall_within_limits(const Wall& wall, const Scene& scene, Precision precision);
Support memory_within_limits(const ContactMemory& memory, const Scene& scene);

}  // namespace grainproof::opencl
