// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Judges the reference by one case and succeeds where a row fails: this program is linked with a planted
// fault in the reference or in the closed forms. Exit codes: 0 noticed, 1 unnoticed, 2 could not judge.
#include <cstdio>
#include <exception>

#include "reference_cpu/reference_engine.hpp"
#include "tests/faults/judged.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    grainproof::reference::ReferenceEngine engine;
    const auto rows = grainproof::faults::judged(argv[1], engine);
    const auto failed = grainproof::faults::failed(rows);
    for (const auto& row : failed)
      std::printf("noticed: %s, step %s: error %.3g, tolerance %.3g %s\n", row.quantity.c_str(),
                  row.step.c_str(), row.error, row.tolerance, row.reason.c_str());
    if (failed.empty()) std::printf("unnoticed by %zu rows\n", rows.size());
    return failed.empty() ? 1 : 0;
  } catch (const std::exception& error) {
    std::printf("could not judge: %s\n", error.what());
    return 2;
  }
}
