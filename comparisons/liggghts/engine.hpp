// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "comparisons/peers/script_engine.hpp"

namespace grainproof {

/// LIGGGHTS as an engine. Its integrator is velocity Verlet with the half-step velocity in the dashpot,
/// which is leap-frog's trajectory too.
class LiggghtsEngine : public peers::ScriptEngine {
 public:
  explicit LiggghtsEngine(peers::ProgramOptions options = {"liggghts"});
};

}  // namespace grainproof
