// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "comparisons/judge.hpp"
#include "comparisons/quantity.hpp"
#include "model/case.hpp"

namespace grainproof {

/// What one run said about one claim.
struct Finding {
  std::size_t scene = 0;       ///< index into Case::scenes
  Measured error;              ///< signed, relative
  double unit_roundoff = 0.0;  ///< of the engine, and of the one it is held against
  double wall_s = 0.0;
  double seen = 0.0;  ///< the two numbers themselves, for a band
  double exact = 0.0;
};

/// An expectation of a case with what is needed to judge one engine by it.
struct Claim {
  const Expectation* says = nullptr;
  const Quantity* quantity = nullptr;
  Engine* oracle = nullptr;         ///< null where the exact value needs no engine
  std::string impossible;           ///< why no run can tell; a failing row by itself
  std::vector<std::size_t> scenes;  ///< that match and that the engine supports
  std::vector<Finding> findings;
};

/// What an engine cannot do, and of which integrator and quantity that is true.
struct Refusal {
  std::string because;
  std::string integrator;
  std::string quantity;  ///< empty where it holds for every claim
  auto operator<=>(const Refusal&) const = default;
};

/// `for` of an expectation: "step" and "integrator" are known for every scene, any other key is a
/// swept one.
bool matches(const Expectation& expectation, const ResolvedScene& resolved);

/// "opencl" restricts to opencl:single and opencl:double alike.
bool is_meant(const Expectation& expectation, const std::string& engine);

/// Claims about numbers that are meant for this engine; `refusals` gets what it cannot do.
std::vector<Claim> claims_for(const Case& subject, Engine& engine, const Oracles& oracles,
                              std::vector<Refusal>& refusals);

}  // namespace grainproof
