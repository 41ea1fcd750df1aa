// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace grainproof::opencl::testing {

struct Finished {
  int status;          ///< exit code
  std::string output;  ///< standard output and error together
};

/// Runs `prefix device_driver arguments` in a shell: `prefix` sets the environment or is a program that wraps
/// it.
Finished run_driver(const std::string& prefix, const std::string& arguments);

}  // namespace grainproof::opencl::testing
