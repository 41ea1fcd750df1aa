// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace grainproof::opencl {

/// CORRECTION_WORDS of kernels/corrections_kept.cl: of a body's velocity, place and spin.
inline constexpr std::size_t correction_words = 3;

}  // namespace grainproof::opencl
