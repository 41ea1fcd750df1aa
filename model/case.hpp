// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/scene.hpp"

namespace grainproof {

/// Which point of a case's sweep a resolved scene is.
struct SweepPoint {
  std::string step;                ///< as written: "contact/64", or the number of seconds
  double steps_per_contact = 0.0;  ///< nominal t_c/Δt; 0 where the step was given in seconds
  int sample = 0;                  ///< onset phase, orientation, …: what a statistic is taken over
  std::map<std::string, std::string> values;  ///< every other swept key: "integrator", "offset", …
  std::string step_because = {};  ///< what chose the step, where that was `step = { error = … }`
};

struct ResolvedScene {
  Scene scene;
  SweepPoint point;
};

/// Measured order of convergence between two steps of the sweep.
struct OrderBound {
  std::string from;
  std::string to;
  double is;
  double within;
};

/// `band` holds the difference of two engines' means over the samples against its own confidence band.
enum class Statistic { maximum, rms, mean, band };

/// When a case is run: always, not with --quick, or with --bulk only.
enum class Tier { quick, standard, bulk };

/// One row of what a case claims. See docs/scene.md, [[expect]].
struct Expectation {
  std::string quantity;
  std::string against;  ///< "closed_form:NAME", "engine:NAME", "invariant:NAME", "value:NUMBER"
  std::map<std::string, std::string> where;  ///< `for` in the file: only sweep points that match
  Statistic statistic = Statistic::maximum;
  std::map<std::string, double> below;  ///< by step label; key "" holds for every step
  std::optional<OrderBound> order;
  std::optional<int> sign;           ///< the mean signed error must have this sign
  double ulps = 32.0;                ///< the round-off floor, in unit round-offs of the engine's precision
  std::vector<std::string> engines;  ///< restricts the row; empty is every engine
  std::string outcome;               ///< "" (completed), "refused" or "went_wrong"
  std::string reason;                ///< text that the refusal or failure must contain
};

/// A scene file, expanded.
struct Case {
  std::string name;  ///< file name without ending
  std::string title;
  Tier tier = Tier::quick;
  std::vector<ResolvedScene> scenes;
  std::vector<Expectation> expectations;
  std::string no_peers_because;  ///< where peers are not asked, the reason shown in the report
  std::string refused;           ///< message, where the scene is refused as it expects to be
};

}  // namespace grainproof
