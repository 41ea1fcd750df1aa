// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>

namespace grainproof::report {

/// Where results were obtained.
struct Machine {
  std::string system;  ///< kernel name and release
  std::string processor;
  unsigned threads = 0;
  std::int64_t memory_bytes = 0;
  std::string compiler;  ///< of this program
  std::string version;   ///< of this program
};

Machine this_machine();

/// The most memory this process has held so far.
std::int64_t peak_memory_bytes();

}  // namespace grainproof::report
