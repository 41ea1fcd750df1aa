// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "app/terminal.hpp"

namespace grainproof::app {

/// Lists what this machine offers: OpenCL devices with their precisions, peers with their versions, and
/// what to install for the rest. Returns an ExitCode.
int doctor(Terminal& terminal);

}  // namespace grainproof::app
