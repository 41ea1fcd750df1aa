// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/terminal.hpp"

namespace grainproof::app {

struct BenchOptions {
  std::vector<std::string> suites;   ///< empty is every one
  std::vector<std::string> engines;  ///< ours to measure; empty is every one there is
  std::string device;
  std::filesystem::path json;   ///< results; empty writes none
  std::filesystem::path out;    ///< folder for results.json, tables.txt and plots; empty writes none
  std::filesystem::path cache;  ///< where settled beds are kept; empty takes the usual place
  bool quick = false;           ///< small scenes and short measurements: all suites in a few minutes
  std::int64_t least = 0;       ///< particles of the smallest scene
  std::int64_t most = 0;        ///< of the largest; 0 takes what memory and time allow
  int rounds = 0;               ///< measurements of each subject; 0 takes the usual number
  double seconds = 0.0;         ///< that one measurement lasts; 0 takes the usual time
  int threads = 0;              ///< rows of `stability` that are measured at once; 0 takes a core each
};

/// Runs benchmark suites. Returns an ExitCode.
int bench(const BenchOptions& options, Terminal& terminal);

/// A line a suite, for --help.
std::string suite_help();

}  // namespace grainproof::app
