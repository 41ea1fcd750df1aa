// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"
#include "report/text_table.hpp"

namespace grainproof::report {

/// What one engine saw of a scene.
struct Seen {
  std::string engine;
  Observations observations;
};

/// Largest difference of any particle in one frame, relative to the scene's scale.
struct FrameDifference {
  double time = 0.0;      ///< s
  double position = 0.0;  ///< over Scale::length
  double velocity = 0.0;  ///< over Scale::speed
  double spin = 0.0;      ///< radius times difference, over Scale::speed; 0 without rotation
};

/// The scene's own scale: its largest diameter and the largest speed of a centre or, with rotation, of
/// a turning surface that either engine saw.
struct Scale {
  double length = 0.0;  ///< m
  double speed = 0.0;   ///< m/s
};

/// Two engines, frame by frame. Only frames of the same time (to half a step) are compared.
struct Difference {
  std::string first;
  std::string second;
  Scale scale;
  std::vector<FrameDifference> frames;
  std::size_t unmatched = 0;                                 ///< frames that only one of the two has
  std::map<std::string, std::pair<double, double>> scalars;  ///< named by both, values of both
};

/// NaN in a frame gives NaN for it.
Difference difference(const Scene& scene, const Seen& first, const Seen& second);

/// For a person: a table of frames for each pair of engines, with the largest at its end.
std::string difference_text(const std::vector<Difference>& differences, const Paint& paint);

nlohmann::json difference_json(const Difference& difference);

}  // namespace grainproof::report
