// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench.hpp"

#include "app/exit_code.hpp"

namespace grainproof::app {

int bench(const BenchOptions& options, Terminal& terminal) {
  for (const std::string& suite : options.suites) terminal.err << "grainproof: no suite " << suite << "\n";
  terminal.err << "grainproof: this version has no benchmark suites; run prints the speed of a single scene"
               << std::endl;
  return input_refused;
}

}  // namespace grainproof::app
