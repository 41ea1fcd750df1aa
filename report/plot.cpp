// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/plot.hpp"

#include <algorithm>
#include <array>

#include "report/plot_frame.hpp"

namespace grainproof::report {
namespace {

// Okabe and Ito's colours: told apart by people with any colour vision.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

/// Its place in order of first appearance.
std::size_t place(std::vector<std::string>& keys, const std::string& key) {
  const auto found = std::find(keys.begin(), keys.end(), key);
  if (found != keys.end()) return static_cast<std::size_t>(found - keys.begin());
  keys.push_back(key);
  return keys.size() - 1;
}

/// Hollow and of growing size, so that markers at one place show all around each other.
std::string marker(double x, double y, std::size_t shape, const std::string& colour) {
  const double size = 3.5 + 1.6 * static_cast<double>(shape);
  const std::string paint = "fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.4\"/>\n";
  switch (shape % 3) {
    case 0:
      return "<circle cx=\"" + pixel(x) + "\" cy=\"" + pixel(y) + "\" r=\"" + pixel(size) + "\" " + paint;
    case 1:
      return "<rect x=\"" + pixel(x - size) + "\" y=\"" + pixel(y - size) + "\" width=\"" + pixel(2 * size) +
             "\" height=\"" + pixel(2 * size) + "\" " + paint;
    default:
      return "<path d=\"M" + pixel(x) + " " + pixel(y - 1.4 * size) + "l" + pixel(1.4 * size) + " " +
             pixel(1.4 * size) + "l" + pixel(-1.4 * size) + " " + pixel(1.4 * size) + "l" +
             pixel(-1.4 * size) + " " + pixel(-1.4 * size) + "z\" " + paint;
  }
}

/// The first scheme is drawn widest, so that it shows below others that lie on it.
std::string line_of(const PlotFrame& frame, const Series& series, std::size_t shape, std::size_t scheme) {
  const std::string colour = colours[scheme % colours.size()];
  const double width = std::max(1.0, 5.0 - 2.0 * static_cast<double>(scheme));
  std::string path;
  std::string markers;
  for (const auto& point : series.points) {
    if (!PlotFrame::drawable(point)) continue;
    const double x = frame.x(point.first);
    const double y = frame.y(point.second);
    path += pixel(x) + "," + pixel(y) + " ";
    markers += marker(x, y, shape, colour);
  }
  return "<polyline points=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
         pixel(width) + "\" stroke-opacity=\"0.5\"/>\n" + markers;
}

std::string bounds_of(const PlotFrame& frame, const Series& series, const std::string& colour) {
  std::string text;
  for (const auto& bound : series.bounds) {
    if (!PlotFrame::drawable(bound)) continue;
    text += "<path d=\"M" + pixel(frame.x(bound.first) - 9) + " " + pixel(frame.y(bound.second)) +
            "h18\" stroke=\"" + colour + "\" stroke-width=\"3\" stroke-opacity=\"0.35\"/>\n";
  }
  return text;
}

std::string legend(const std::vector<std::string>& schemes, const std::vector<std::string>& engines) {
  const double x = PlotFrame::right + 22;
  double y = PlotFrame::top + 10;
  std::string text;
  for (std::size_t i = 0; i < schemes.size(); ++i, y += 18) {
    text += "<path d=\"M" + pixel(x - 7) + " " + pixel(y - 4) + "h14\" stroke=\"" +
            colours[i % colours.size()] + "\" stroke-width=\"3\"/>\n" +
            svg_text(x + 14, y, "", escaped(schemes[i]));
  }
  y += 8;
  for (std::size_t i = 0; i < engines.size(); ++i, y += 22)
    text += marker(x, y - 4, i, "#444") + svg_text(x + 26, y, "", escaped(engines[i]));
  text += "<path d=\"M" + pixel(x - 9) + " " + pixel(y + 4) + "h18\" stroke=\"#444\" stroke-width=\"3\" " +
          "stroke-opacity=\"0.35\"/>\n" + svg_text(x + 14, y + 8, "", "tolerance");
  return text;
}

}  // namespace

bool Plot::worth_drawing() const {
  return std::any_of(series.begin(), series.end(), [](const Series& one) {
    return std::count_if(one.points.begin(), one.points.end(), PlotFrame::drawable) > 1;
  });
}

std::string svg(const Plot& plot) {
  const PlotFrame frame(plot);
  std::vector<std::string> schemes;
  std::vector<std::string> engines;
  std::string drawn;
  for (const Series& series : plot.series) {
    const std::size_t scheme = place(schemes, series.colour_key);
    drawn += bounds_of(frame, series, colours[scheme % colours.size()]) +
             line_of(frame, series, place(engines, series.marker_key), scheme);
  }
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pixel(plot_width) + " " +
         pixel(plot_height) + "\" width=\"" + pixel(plot_width) + "\" height=\"" + pixel(plot_height) +
         "\" font-family=\"sans-serif\" font-size=\"12\" role=\"img\">\n" + frame.axes(plot) + drawn +
         legend(schemes, engines) + "</svg>\n";
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

}  // namespace grainproof::report
