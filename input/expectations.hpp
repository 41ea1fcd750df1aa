// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "input/node.hpp"
#include "input/read_case.hpp"
#include "model/case.hpp"

namespace grainproof::input {

/// An expectation and where it stands.
struct WrittenExpectation {
  Expectation expectation;
  Node place;
};

/// Refuses names that `options` does not have.
std::vector<WrittenExpectation> read_expectations(const std::vector<Node>& tables,
                                                  const ReadOptions& options);

/// Refuses an expectation that no scene of the sweep meets, or that names a step which isn't swept.
void check_expectations(const std::vector<WrittenExpectation>& written,
                        const std::vector<ResolvedScene>& scenes);

}  // namespace grainproof::input
