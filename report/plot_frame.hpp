// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>

#include "report/plot.hpp"

namespace grainproof::report {

inline constexpr double plot_width = 760.0;
inline constexpr double plot_height = 400.0;

/// Where data land in the picture: logarithmic axes inside fixed margins.
class PlotFrame {
 public:
  explicit PlotFrame(const Plot& plot);

  double x(double value) const;
  double y(double value) const;

  /// Axes, grid, ticks and titles.
  std::string axes(const Plot& plot) const;

  static bool drawable(const std::pair<double, double>& point);
  static constexpr double left = 76.0;
  static constexpr double right = 520.0;
  static constexpr double top = 40.0;
  static constexpr double bottom = 340.0;

 private:
  std::string x_ticks(const Plot& plot) const;
  std::string y_ticks() const;

  double x_low_, x_high_, y_low_, y_high_;  ///< log10
};

/// Two decimals are a hundredth of a pixel.
std::string pixel(double value);

std::string svg_text(double x, double y, const std::string& attributes, const std::string& text);

}  // namespace grainproof::report
