// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "analytic/contact_scales.hpp"
#include "model/scene.hpp"

namespace grainproof::analytic {

/// The lightest contact that two materials, or a material and a wall, can make in a scene.
struct PossibleContact {
  std::string between;
  double mass;    ///< effective, kg
  double radius;  ///< effective (R* of hertz.3), m
  const ContactLaws* laws;
  std::pair<std::size_t, std::size_t> materials;
  bool on_wall;
  double slowest_drag;  ///< 1/τ of the partner that drag slows least, 1/s; 0 without a flow
  double fastest_drag;
  std::pair<double, double> masses;     ///< of the two bodies, kg; infinite for a wall or a fixed particle
  std::pair<double, double> diameters;  ///< m; likewise
};

/// One for every two materials, and every material and wall, that have laws and of which a body can move.
std::vector<PossibleContact> possible_contacts(const Scene& scene);

/// Time scale, stiffness and dashpot of one contact.
ContactScale scale_of(const Scene& scene, const PossibleContact& contact, const ClosingSpeeds& speeds);

/// 1/τ = 18 μ_f/(ρ d²); 0 without a flow (fields.5).
double drag_rate(const Flow& flow, double density, double diameter);

}  // namespace grainproof::analytic
