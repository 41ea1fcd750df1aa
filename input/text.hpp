// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

/// Words and numbers in messages and labels.
namespace grainproof::input {

/// The shortest decimal that reads back as the same number: 0.001, 1e-10, 64.
std::string shortest(double number);

/// In double quotes, cut where it is long.
std::string in_quotes(std::string_view text);

/// "a", "b" or "c"
std::string one_of(const std::vector<std::string_view>& names);

/// The name that `wanted` was probably meant to be; empty where none is near.
std::string_view nearest(std::string_view wanted, const std::vector<std::string_view>& names);

/// What stands behind "expected" for a name that is none of `names`.
std::string meant(std::string_view wanted, const std::vector<std::string_view>& names);

}  // namespace grainproof::input
