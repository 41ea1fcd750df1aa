// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "analytic/measured_errors.hpp"
#include "model/scene.hpp"

namespace grainproof::analytic {

/// No step is taken above this share of the stability limit: a particle that six others touch is up to
/// sqrt(6) times as stiff as the single contact that the limit is of (integrators.11).
inline constexpr double safe_share = 0.4;

/// error ≈ C (Δt/t_c)^p about the step that reaches it.
struct StepsForError {
  double steps;  ///< a contact
  double constant;
  double order;
};

/// The fewest steps from which on every measured error is at most `error`, between the measured ones by a
/// power law; beyond the finest by the order over the last three. Never fewer than the coarsest measured.
/// Nothing where the errors measured stop falling above `error`.
std::optional<StepsForError> steps_for_error(const MeasuredErrors& measured, double error);

/// A step and what decided it, or what is not known.
struct StepForError {
  double step = 0.0;    ///< s
  std::string because;  ///< "… with velocity_verlet: error ≈ …"
  std::string lacks;    ///< why there is no step; empty where there is one
};

/// The largest step at which no contact of the scene, and no drag, makes a larger error than `error` by the
/// measured constants of the scene's laws and integrator, and below safe_share of the stability limit.
StepForError step_for_error(const Scene& scene, double error, std::optional<double> impact_speed = {});

}  // namespace grainproof::analytic
