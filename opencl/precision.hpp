// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace grainproof::opencl {

/// Arithmetic of an engine: docs/precision.md.
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

inline constexpr std::array every_precision{Precision::single_precision, Precision::mixed_precision,
                                            Precision::double_precision};

constexpr std::optional<Precision> precision_named(std::string_view name) {
  for (const Precision precision : every_precision)
    if (name == name_of(precision)) return precision;
  return std::nullopt;
}

/// Whether a device without doubles is no use.
constexpr bool needs_doubles(Precision precision) {
  return precision != Precision::single_precision;
}

}  // namespace grainproof::opencl
