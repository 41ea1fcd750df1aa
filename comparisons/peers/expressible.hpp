// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/engine.hpp"

namespace grainproof::peers {

/// Everything but contacts: what both programs have, said in the name of `program`.
Support setting_support(const Scene& scene, const Request& request, const std::string& program);

/// History friction as a program has it.
struct HistoryVariant {
  CoulombLimit limit;
  TorqueArm arm;
  SpringTurn turn;
};

/// Whether friction is what `program` has as `own`. What makes no difference is not asked for: the limit
/// without a tangential dashpot, the arm without rotation. Friction without a history has the arm r.
Support friction_support(const Scene& scene, const ContactLaws& laws, const HistoryVariant& own,
                         const std::string& program);

}  // namespace grainproof::peers
