// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/onset/end_error.hpp"

#include <cmath>

namespace grainproof::reference {

// Four terms, then the formula of Euler and Maclaurin, which from there on is good to 1e-7.
double hurwitz(double exponent, double first) {
  constexpr int terms = 4;
  double sum = 0.0;
  for (int j = 0; j < terms; ++j) sum += std::pow(first + j, exponent);
  const double from = first + terms, power = std::pow(from, exponent);
  return sum - power * from / (exponent + 1.0) + 0.5 * power - exponent * power / (12.0 * from) +
         exponent * (exponent - 1.0) * (exponent - 2.0) * power / (720.0 * from * from * from);
}

}  // namespace grainproof::reference
