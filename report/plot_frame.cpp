// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/plot_frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string svg_line(double x1, double y1, double x2, double y2, const char* colour) {
  return "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) + "\" y2=\"" +
         pixel(y2) + "\" stroke=\"" + colour + "\"/>\n";
}

struct Range {
  double low = infinity;
  double high = -infinity;

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

std::string superscript(int exponent) {
  return "10<tspan dy=\"-5\" font-size=\"9\">" + std::to_string(exponent) + "</tspan>";
}

}  // namespace

std::string pixel(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

std::string svg_text(double x, double y, const std::string& attributes, const std::string& text) {
  return "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" " + attributes + ">" + text + "</text>\n";
}

bool PlotFrame::drawable(const std::pair<double, double>& point) {
  return point.first > 0.0 && point.second > 0.0 && std::isfinite(point.first) && std::isfinite(point.second);
}

PlotFrame::PlotFrame(const Plot& plot) {
  Range x_range;
  Range y_range;
  for (const Series& series : plot.series)
    for (const auto* points : {&series.points, &series.bounds})
      for (const auto& point : *points)
        if (drawable(point)) {
          x_range.take(std::log10(point.first));
          y_range.take(std::log10(point.second));
        }
  const double margin = std::max(0.06 * (x_range.high - x_range.low), 0.05);
  x_low_ = x_range.low - margin;
  x_high_ = x_range.high + margin;
  y_low_ = std::floor(y_range.low - 0.05);
  y_high_ = std::ceil(y_range.high + 0.05);
}

double PlotFrame::x(double value) const {
  return left + (right - left) * (std::log10(value) - x_low_) / (x_high_ - x_low_);
}

double PlotFrame::y(double value) const {
  return bottom - (bottom - top) * (std::log10(value) - y_low_) / (y_high_ - y_low_);
}

std::string PlotFrame::y_ticks() const {
  std::string text;
  const int decades = static_cast<int>(y_high_ - y_low_);
  const int every = std::max(1, decades / 8);
  for (int exponent = static_cast<int>(y_low_); exponent <= static_cast<int>(y_high_); exponent += every) {
    const double at = y(std::pow(10.0, exponent));
    text += svg_line(left, at, right, at, "#e4e4e4");
    text += svg_text(left - 8, at + 4, "text-anchor=\"end\"", superscript(exponent));
  }
  return text;
}

std::string PlotFrame::x_ticks(const Plot& plot) const {
  std::set<double> places;
  for (const Series& series : plot.series)
    for (const auto& point : series.points)
      if (drawable(point)) places.insert(point.first);
  std::string text;
  double last = -infinity;
  for (double value : places) {
    const double at = x(value);
    if (at - last < 44.0) continue;
    last = at;
    text += svg_line(at, top, at, bottom, "#e4e4e4");
    text += svg_text(at, bottom + 18, "text-anchor=\"middle\"",
                     plot.x_is_fraction ? "1/" + brief(1.0 / value) : brief(value));
  }
  return text;
}

std::string PlotFrame::axes(const Plot& plot) const {
  const double middle = (top + bottom) / 2.0;
  return svg_text(left, 22, "font-weight=\"bold\"", escaped(plot.title)) + x_ticks(plot) + y_ticks() +
         "<rect x=\"" + pixel(left) + "\" y=\"" + pixel(top) + "\" width=\"" + pixel(right - left) +
         "\" height=\"" + pixel(bottom - top) + "\" fill=\"none\" stroke=\"#888\"/>\n" +
         svg_text((left + right) / 2.0, bottom + 42, "text-anchor=\"middle\"", escaped(plot.x_title)) +
         svg_text(20, middle, "text-anchor=\"middle\" transform=\"rotate(-90 20 " + pixel(middle) + ")\"",
                  escaped(plot.y_title));
}

}  // namespace grainproof::report
