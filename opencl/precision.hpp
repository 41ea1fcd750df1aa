// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

namespace grainproof::opencl {

/// Arithmetic of an engine. `mixed` has its name in the seam and is refused by supports() as not built.
enum class Precision { single_precision, mixed_precision, double_precision };

constexpr std::string_view name_of(Precision precision) {
  switch (precision) {
    case Precision::single_precision:
      return "single";
    case Precision::mixed_precision:
      return "mixed";
    case Precision::double_precision:
      return "double";
  }
  return "unknown";
}

}  // namespace grainproof::opencl
