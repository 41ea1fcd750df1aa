// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "opencl/layout.hpp"
#include "opencl/scene_image.hpp"

namespace grainproof::opencl {

/// Throws RunWentWrong for the particle with the smallest id whose fault belongs to `step`.
/// `faults` holds one cl_int4 a particle: step, cause, partner or face. Steps are counted from `first_step`
/// on.
[[noreturn]] void throw_failure(const Scene& scene, cl_int step, const Bytes& faults,
                                std::int64_t first_step = 0);

}  // namespace grainproof::opencl
