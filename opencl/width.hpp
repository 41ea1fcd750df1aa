// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::opencl {

/// How many particles a work-item of the dense path takes: `many` where a work-item has vectors (sixteen in
/// single precision, eight in double), `one` where it is a lane itself. `automatic`: one on a GPU.
enum class Width { automatic, one, many };

constexpr bool takes_one(Width width, bool gpu) {
  return width == Width::one || (width == Width::automatic && gpu);
}

}  // namespace grainproof::opencl
