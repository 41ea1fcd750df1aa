// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "app/terminal.hpp"

namespace grainproof::app {

struct RunOptions {
  std::string scene;  ///< a case's name or a file
  std::string engine = "reference";
  std::string precision;
  std::string device;
  std::filesystem::path out;   ///< folder for frames and summary.json; empty writes none
  std::filesystem::path json;  ///< summary; empty writes none
  bool csv = false;
  bool ledger = false;     ///< wanted, however large the scene
  bool no_ledger = false;  ///< not wanted, however small
  bool no_sentinels = false;
  bool no_self_test = false;
  std::filesystem::path from;    ///< checkpoint to go on from; empty starts at the beginning
  std::string checkpoint_every;  ///< steps, or seconds with an s; empty writes none
  bool force = false;
  int nth = 0;  ///< which scene of a sweep, from 1; 0 is the first, with a remark
};

/// Runs one scene on one engine. Returns an ExitCode; throws InputRefused, EngineFailed.
int run_scene(const RunOptions& options, Terminal& terminal);

}  // namespace grainproof::app
