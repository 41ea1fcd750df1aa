// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/case.hpp"

namespace grainproof {

enum class Verdict { pass, fail, unsupported };

/// One line of the report: one engine, one claim of a case, one step of the sweep (or the order
/// measured over several). A number that does not exist is NaN.
struct Row {
  std::string case_name;
  std::string engine;     ///< as the command line spells it
  std::string precision;  ///< "single", "mixed", "double"; empty where unknown
  std::string integrator;
  std::string quantity;  ///< empty where an engine does not support a scene at all
  std::string against;   ///< as the case has it
  Statistic statistic = Statistic::maximum;
  std::string step;                           ///< label of the sweep; empty in a row of an order
  std::map<std::string, std::string> values;  ///< the other swept keys
  int samples = 0;                            ///< that the statistic was taken over
  double error =
      std::numeric_limits<double>::quiet_NaN();  ///< the statistic; in a row of an order |order − is|
  double tolerance = std::numeric_limits<double>::quiet_NaN();  ///< bound and round-off floor
  std::optional<double> order;                                  ///< measured; only in a row of an order
  std::optional<OrderBound> order_expected;
  std::vector<std::pair<double, double>> points;  ///< (step in s, statistic) that the order was fitted to
  Verdict verdict = Verdict::fail;
  std::string reason;   ///< why it failed or is unsupported; a remark where it passed
  double wall_s = 0.0;  ///< spent by the engine on the scenes of this row
};

constexpr const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::unsupported:
      return "unsupported";
  }
  return "unknown";
}

}  // namespace grainproof
