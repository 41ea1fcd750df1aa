// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::analytic {

/// A scene, the closed form that solves it, and how finely double arithmetic resolves it.
struct FormCase {
  std::string label;
  std::string form;
  std::string analytic_takes;
  Scene scene;
  double time_scale;         ///< s, of the fastest change
  double speed_scale;        ///< m/s
  double position_roundoff;  ///< m
  double velocity_roundoff;  ///< m/s
};

std::vector<FormCase> form_cases();

}  // namespace grainproof::analytic
