// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/terminal.hpp"

namespace grainproof::app {

struct VerifyOptions {
  std::vector<std::string> cases;    ///< names or files; empty is every case there is
  std::vector<std::string> engines;  ///< empty is ours in every precision and every peer found
  std::string device;
  std::filesystem::path json;  ///< results; empty writes none
  std::filesystem::path out;   ///< folder for results.json and report.html; empty writes none
  bool quick = false;          ///< the cases of tier quick only
  bool bulk = false;           ///< those of tier bulk too
  bool list = false;           ///< name the cases only
  std::size_t jobs = 0;        ///< cases judged at the same time; 0 leaves it to the machine
};

/// Judges engines by cases. Returns an ExitCode; throws InputRefused before anything runs.
int verify(const VerifyOptions& options, Terminal& terminal);

}  // namespace grainproof::app
