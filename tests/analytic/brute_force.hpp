// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

/// Equations of motion written a second time and integrated in small steps.
namespace grainproof::analytic {

/// One step of the classical fourth-order method.
template <std::size_t N, class Rates>
std::array<long double, N> runge_kutta(const std::array<long double, N>& y, long double time, long double h,
                                       const Rates& rates) {
  using State = std::array<long double, N>;
  const auto plus = [&](long double part, const State& k) {
    State out = y;
    for (std::size_t i = 0; i < N; ++i) out[i] += part * k[i];
    return out;
  };
  const State a = rates(time, y), b = rates(time + h / 2, plus(h / 2, a)),
              c = rates(time + h / 2, plus(h / 2, b)), d = rates(time + h, plus(h, c));
  State out = y;
  for (std::size_t i = 0; i < N; ++i) out[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
  return out;
}

/// From time 0, in `steps` steps.
template <std::size_t N, class Rates>
std::array<long double, N> integrated(std::array<long double, N> y, long double end, int steps,
                                      const Rates& rates) {
  for (int n = 0; n < steps; ++n) y = runge_kutta(y, end * n / steps, end / steps, rates);
  return y;
}

}  // namespace grainproof::analytic
