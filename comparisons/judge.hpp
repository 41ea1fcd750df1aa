// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "comparisons/verdict.hpp"
#include "model/engine.hpp"

namespace grainproof {

/// Turns `against` ("closed_form:NAME", "engine:NAME") into the engine that knows the exact answer.
/// Null where there is none of that name; the engine outlives the judge.
using Oracles = std::function<Engine*(const std::string& against)>;

/// Scenes observed so far, out of how many.
using Progress = std::function<void(std::size_t done, std::size_t total)>;

/// Judges engines by one case. Each scene is observed once an engine; what the engines named in
/// `against` saw is kept, so that judging the next engine does not run them again.
class Judge {
 public:
  /// `subject` must outlive the judge.
  Judge(const Case& subject, Oracles oracles);
  ~Judge();

  /// One row a claim and step, in the order of the file. Never throws for what an engine does:
  /// an engine that fails gives failing rows with its message.
  std::vector<Row> rows(Engine& engine, const Progress& progress = {});

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A judge for a single engine.
std::vector<Row> judge(const Case& subject, Engine& engine, const Oracles& oracles,
                       const Progress& progress = {});

}  // namespace grainproof
