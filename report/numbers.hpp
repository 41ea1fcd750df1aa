// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace grainproof::report {

/// Three significant digits: "1.23e-05", "0.0153", "64". Infinities and NaN as "inf", "nan".
std::string brief(double value);

/// "1.02", as orders of convergence are given.
std::string two_decimals(double value);

/// The shortest text that reads back as the same double; "nan" and "inf" as such.
std::string exact(double value);

/// A duration as people say it: "3.1 ms", "0.42 s", "12 s", "3 min 05 s", "2 h 10 min".
std::string duration(double seconds);

/// 12345678 as "12 345 678", with narrow no-break spaces.
std::string grouped(long long count);

}  // namespace grainproof::report
