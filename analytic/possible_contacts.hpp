// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::analytic {

/// The lightest contact that two materials, or a material and a wall, can make in a scene.
struct PossibleContact {
  std::string between;
  double mass;  ///< effective, kg
  const ContactLaws* laws;
  double slowest_drag;  ///< 1/τ of the partner that drag slows least, 1/s; 0 without a flow
  double fastest_drag;
};

std::vector<PossibleContact> possible_contacts(const Scene& scene);

/// 1/τ = 18 μ_f/(ρ d²); 0 without a flow (fields.5).
double drag_rate(const Flow& flow, double density, double diameter);

}  // namespace grainproof::analytic
