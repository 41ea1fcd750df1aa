// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "app/terminal.hpp"

namespace grainproof::app {

/// The whole program: reads the arguments, runs one command, says what went wrong. Returns an ExitCode.
int run_command_line(int argc, const char* const* argv, Terminal& terminal);

}  // namespace grainproof::app
