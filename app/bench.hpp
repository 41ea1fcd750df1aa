// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "app/terminal.hpp"

namespace grainproof::app {

struct BenchOptions {
  std::vector<std::string> suites;
};

/// Runs benchmark suites. Returns an ExitCode.
int bench(const BenchOptions& options, Terminal& terminal);

}  // namespace grainproof::app
