// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace grainproof::bench {

/// What a benchmark program is asked for on its command line; Google Benchmark's own options come beside it.
struct Settings {
  std::filesystem::path data;   ///< folder with kernels/ and benchmarks/
  std::filesystem::path cache;  ///< where states that take long to make are kept
  std::string device;           ///< as EngineSettings::device
  int threads = 0;              ///< of PoCL, and processes of a peer; 0 takes every core
  int rounds = 3;               ///< measurements of each subject, interleaved with the others'
  double seconds = 0.5;         ///< that one measurement is to last
  std::vector<std::string> scenes;
  std::vector<std::string> engines;
  std::vector<std::int64_t> particles;
  bool quick = false;  ///< fewer points
};

/// Cores that `threads` means.
int thread_count(const Settings& settings);

/// A whole benchmark program: reads the options, calls `add` to register benchmarks, runs them.
int run_benchmarks(int argc, char** argv, void (*add)(const Settings&));

}  // namespace grainproof::bench
