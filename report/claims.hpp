// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparisons/verdict.hpp"

namespace grainproof::report {

/// What one engine and integrator did about one claim, over all steps of the sweep.
struct Line {
  std::string engine;
  std::string integrator;
  std::string set_up;        ///< the other swept keys, "offset 1, orientation 3"; mostly empty
  std::vector<Row> steps;    ///< a row a step, in the order of the sweep
  std::optional<Row> order;  ///< the row of the measured order

  Verdict verdict() const;
  /// Smallest tolerance/error over the steps; infinite without an error, nothing where no step has both.
  std::optional<double> margin() const;
};

/// One claim of a case: a quantity against what is known of it.
struct Claim {
  std::string quantity;
  std::string against;
  Statistic statistic = Statistic::maximum;
  int samples = 0;
  std::vector<std::string> steps;  ///< labels, in the order of the sweep
  std::vector<Line> lines;
};

/// The rows of one case, put together for reading.
struct CaseRows {
  std::string name;
  std::vector<Claim> claims;
  std::vector<std::string> unsupported;  ///< "liggghts: …", each once
};

/// Rows of one case in any order of engines; the order of first appearance is kept throughout.
CaseRows read_together(const std::vector<Row>& rows);

/// The worst of several: fail before pass before unsupported.
Verdict worst(const std::vector<Row>& rows);

/// "rms", "maximum", "mean".
std::string_view name_of(Statistic statistic);

/// "restitution, rms of 256, against closed_form:normal_collision; errors relative to the exact value"
std::string title(const Claim& claim);

}  // namespace grainproof::report
