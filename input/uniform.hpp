// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <random>

#include "model/vec3.hpp"

namespace grainproof::input {

/// Random numbers that are the same on every platform: the standard fixes the engine's output but not
/// that of its distributions, so the mapping is our own. docs/scene.md, "Random numbers".
class Uniform {
 public:
  explicit Uniform(std::int64_t seed) : engine_(static_cast<std::uint64_t>(seed)) {}

  /// In [0, 1), the top 53 bits of a draw.
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// Each component in [-1, 1).
  Vec3 in_cube() {
    Vec3 out;
    for (int axis = 0; axis < 3; ++axis) out[axis] = 2.0 * (*this)() - 1.0;
    return out;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace grainproof::input
