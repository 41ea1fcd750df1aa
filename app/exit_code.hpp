// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::app {

/// What the program returns to the shell.
enum ExitCode : int { all_held = 0, verdict_failed = 1, input_refused = 2, run_went_wrong = 3 };

}  // namespace grainproof::app
