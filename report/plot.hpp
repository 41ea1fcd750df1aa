// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace grainproof::report {

/// What is drawn as one line with markers. Lines that lie on each other stay visible: the colour says the
/// scheme, the marker's shape and size the engine.
struct Series {
  std::string colour_key;  ///< the same colour for the same key
  std::string marker_key;  ///< the same marker for the same key
  std::vector<std::pair<double, double>> points;
  std::vector<std::pair<double, double>> bounds;  ///< tolerances, drawn as bars
};

/// Error against step, both logarithmic. Points that are not positive and finite are left out.
struct Plot {
  std::string title;
  std::string x_title;
  std::string y_title;
  bool x_is_fraction = false;  ///< ticks read "1/8" instead of decades
  std::vector<Series> series;

  bool worth_drawing() const;  ///< some series has two points that can be drawn
};

/// A self-contained <svg> element.
std::string svg(const Plot& plot);

/// Text as it stands inside XML.
std::string escaped(const std::string& text);

}  // namespace grainproof::report
