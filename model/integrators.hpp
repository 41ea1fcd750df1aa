// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace grainproof {

/// Time integrators, defined by their equations in docs/laws/integrators.md.
enum class Integrator {
  euler_trapezoid,
  euler_trapezoid_implicit_drag,
  leapfrog_verlet,
  velocity_verlet,
  velocity_verlet_predicted,  ///< forces take the velocity predicted for the boundary: second order with
                              ///< dashpots
  onset_corrected,            ///< the same, and a contact acts for the time it lasted within a step
  velocity_verlet_implicit,   ///< each dashpot solved with its own effect on the velocity that it takes
  pefrl,                      ///< position-extended Forest-Ruth: fourth order where forces are smooth
};

inline constexpr std::array<std::pair<std::string_view, Integrator>, 8> integrator_names{{
    {"euler_trapezoid", Integrator::euler_trapezoid},
    {"euler_trapezoid_implicit_drag", Integrator::euler_trapezoid_implicit_drag},
    {"leapfrog_verlet", Integrator::leapfrog_verlet},
    {"velocity_verlet", Integrator::velocity_verlet},
    {"velocity_verlet_predicted", Integrator::velocity_verlet_predicted},
    {"onset_corrected", Integrator::onset_corrected},
    {"velocity_verlet_implicit", Integrator::velocity_verlet_implicit},
    {"pefrl", Integrator::pefrl},
}};

/// Of a scene file that names none: the least time to a given error (docs/integrators.md).
inline constexpr Integrator usual_integrator = Integrator::onset_corrected;

constexpr std::string_view name_of(Integrator integrator) {
  for (const auto& [name, value] : integrator_names)
    if (value == integrator) return name;
  return "unknown";
}

/// How often contacts are gone through in a step. One before the first step comes on top.
constexpr int evaluations_a_step(Integrator integrator) {
  if (integrator == Integrator::pefrl) return 4;
  return integrator == Integrator::velocity_verlet_implicit ? 2 : 1;  // springs first, then all
}

constexpr std::optional<Integrator> integrator_named(std::string_view wanted) {
  for (const auto& [name, value] : integrator_names)
    if (name == wanted) return value;
  return std::nullopt;
}

}  // namespace grainproof
