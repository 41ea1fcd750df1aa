// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "report/machine.hpp"

namespace grainproof::report {

/// One page that needs nothing else: the pictures, each an <img> that holds its SVG and is called by its
/// name, then the tables as the terminal shows them.
std::string bench_page(const Machine& machine,
                       const std::vector<std::pair<std::string, std::string>>& pictures,
                       const std::string& tables);

}  // namespace grainproof::report
