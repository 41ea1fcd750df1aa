// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <span>
#include <string_view>

#include "model/integrators.hpp"

/// What error an integrator makes in one contact, measured: docs/benchmarks.md, "Constants of the step".
namespace grainproof::analytic {

enum class ErrorLaw { linear, no_tension, linear_history, hertz, hertz_history, drag };

std::string_view name_of(ErrorLaw law);

/// Steps a contact that errors were measured at; of drag, steps a relaxation time.
inline constexpr std::array<double, 6> measured_at{8, 16, 32, 64, 128, 256};

/// Root mean square over phases of the relative velocity's error after a contact, over the speed before; of
/// drag the error after a relaxation time, over the speed before.
struct MeasuredErrors {
  ErrorLaw law;
  Integrator integrator;
  double restitution;
  std::array<double, measured_at.size()> error;
};

/// Sorted by law, integrator and falling restitution. Written by bench_step_constants; measured_errors.cpp.
std::span<const MeasuredErrors> measured_errors();

}  // namespace grainproof::analytic
