// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/numbers.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace grainproof::report {
namespace {

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), pattern, arguments...);
  return text.data();
}

}  // namespace

std::string brief(double value) {
  const double size = std::abs(value);
  if (!std::isfinite(value) || size == 0.0 || (size >= 1e-3 && size < 999.5)) return format("%.3g", value);
  return format(size >= 999.5 && size < 1e5 ? "%.0f" : "%.2e", value);
}

std::string two_decimals(double value) {
  return format("%.2f", value);
}

std::string exact(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string duration(double seconds) {
  if (seconds < 0.1) return format("%.2g ms", 1e3 * seconds);
  if (seconds < 10.0) return format("%.2f s", seconds);
  const long whole = std::lround(seconds);
  if (whole < 60) return format("%ld s", whole);
  if (whole < 3600) return format("%ld min %02ld s", whole / 60, whole % 60);
  return format("%ld h %02ld min", whole / 3600, whole / 60 % 60);
}

std::string grouped(long long count) {
  std::string text = std::to_string(count);
  const std::size_t first = text[0] == '-' ? 1 : 0;
  for (std::size_t at = text.size(); at > first + 3;) {
    at -= 3;
    text.insert(at, "\u202f");
  }
  return text;
}

}  // namespace grainproof::report
