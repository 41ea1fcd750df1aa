// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/terminal.hpp"

namespace grainproof::app {

struct CompareOptions {
  std::string scene;
  std::vector<std::string> engines;  ///< the others are held against the first; empty is reference,opencl
  std::vector<std::string> exact;    ///< one or two, to be compared bit by bit instead
  std::string other;                 ///< scene of the second, where it is another
  std::string device;
  std::filesystem::path out;  ///< folder for compare.json and every engine's frames; empty writes none
  std::filesystem::path json;
  bool force = false;
  int nth = 0;
};

/// Runs one scene on several engines and shows how far apart they are. Returns an ExitCode.
int compare(const CompareOptions& options, Terminal& terminal);

}  // namespace grainproof::app
