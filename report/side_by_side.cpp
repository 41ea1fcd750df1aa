// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/side_by_side.hpp"

#include <algorithm>
#include <cmath>

#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

constexpr std::size_t most_frames_shown = 20;

/// std::max drops a NaN on one side; here it stays.
double larger(double a, double b) {
  return std::isnan(a) || a > b ? a : b;
}

double length_between(const Domain& domain, Vec3 apart) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis))
      apart[axis] -= domain.extent()[axis] * std::round(apart[axis] / domain.extent()[axis]);
  return apart.norm();
}

double largest_speed(const Scene& scene, const Observations& seen) {
  double largest = 0.0;
  for (const Frame& frame : seen.frames) {
    for (const Vec3& velocity : frame.velocity) largest = std::max(largest, velocity.norm());
    for (std::size_t i = 0; i < frame.angular_velocity.size(); ++i)
      largest = std::max(largest, 0.5 * scene.particles[i].diameter * frame.angular_velocity[i].norm());
  }
  return largest;
}

Scale scale_of(const Scene& scene, const Observations& first, const Observations& second) {
  Scale scale;
  for (const Particle& particle : scene.particles) scale.length = std::max(scale.length, particle.diameter);
  scale.speed = std::max(largest_speed(scene, first), largest_speed(scene, second));
  return scale;
}

FrameDifference between(const Scene& scene, const Scale& scale, const Frame& first, const Frame& second) {
  FrameDifference apart{first.time, 0.0, 0.0, 0.0};
  for (std::size_t i = 0; i < std::min(first.position.size(), second.position.size()); ++i) {
    apart.position = larger(
        length_between(scene.domain, second.position[i] - first.position[i]) / scale.length, apart.position);
    const double speed = (second.velocity[i] - first.velocity[i]).norm();
    apart.velocity = larger(speed == 0.0 ? 0.0 : speed / scale.speed, apart.velocity);
  }
  for (std::size_t i = 0; i < std::min(first.angular_velocity.size(), second.angular_velocity.size()); ++i) {
    const double speed =
        0.5 * scene.particles[i].diameter * (second.angular_velocity[i] - first.angular_velocity[i]).norm();
    apart.spin = larger(speed == 0.0 ? 0.0 : speed / scale.speed, apart.spin);
  }
  return apart;
}

FrameDifference largest_of(const std::vector<FrameDifference>& frames) {
  FrameDifference largest;
  for (const FrameDifference& frame : frames) {
    largest.position = larger(frame.position, largest.position);
    largest.velocity = larger(frame.velocity, largest.velocity);
    largest.spin = larger(frame.spin, largest.spin);
  }
  return largest;
}

std::vector<std::size_t> shown_frames(std::size_t count) {
  std::vector<std::size_t> shown;
  const std::size_t rows = std::min(count, most_frames_shown);
  for (std::size_t i = 0; i < rows; ++i) shown.push_back(rows == 1 ? 0 : i * (count - 1) / (rows - 1));
  return shown;
}

std::string frames_text(const Difference& apart, const Paint& paint) {
  TextTable table({{"time / s", Align::right},
                   {"position / diameter", Align::right},
                   {"velocity / largest speed", Align::right},
                   {"radius × spin / largest speed", Align::right}});
  for (std::size_t i : shown_frames(apart.frames.size())) {
    const FrameDifference& frame = apart.frames[i];
    table.add({brief(frame.time), brief(frame.position), brief(frame.velocity), brief(frame.spin)});
  }
  const FrameDifference largest = largest_of(apart.frames);
  table.add({"largest", brief(largest.position), brief(largest.velocity), brief(largest.spin)});
  return table.text(paint, "  ");
}

std::string scalars_text(const Difference& apart, const Paint& paint) {
  TextTable table({{"scalar"},
                   {apart.first, Align::right},
                   {apart.second, Align::right},
                   {"relative difference", Align::right}});
  for (const auto& [name, values] : apart.scalars) {
    const double scale = std::max(std::abs(values.first), std::abs(values.second));
    const double size = std::abs(values.second - values.first);
    table.add({name, brief(values.first), brief(values.second), brief(size == 0.0 ? 0.0 : size / scale)});
  }
  return table.empty() ? "" : table.text(paint, "  ");
}

}  // namespace

Difference difference(const Scene& scene, const Seen& first, const Seen& second) {
  Difference apart{
      first.engine, second.engine, scale_of(scene, first.observations, second.observations), {}, 0, {}};
  const auto& others = second.observations.frames;
  for (const Frame& frame : first.observations.frames) {
    const auto same = std::find_if(others.begin(), others.end(), [&](const Frame& other) {
      return std::abs(other.time - frame.time) < scene.run.step / 2.0;
    });
    if (same != others.end()) apart.frames.push_back(between(scene, apart.scale, frame, *same));
  }
  apart.unmatched = first.observations.frames.size() + others.size() - 2 * apart.frames.size();
  for (const auto& [name, value] : first.observations.scalars)
    if (const auto other = second.observations.scalars.find(name); other != second.observations.scalars.end())
      apart.scalars[name] = {value, other->second};
  return apart;
}

std::string difference_text(const std::vector<Difference>& differences, const Paint& paint) {
  std::string text;
  for (const Difference& apart : differences) {
    text += paint.bold(apart.second + " against " + apart.first) +
            "  largest difference of any particle; diameter " + brief(apart.scale.length) +
            " m, largest speed " + brief(apart.scale.speed) + " m/s\n";
    text += frames_text(apart, paint) + scalars_text(apart, paint);
    if (apart.unmatched > 0) text += "  " + std::to_string(apart.unmatched) + " frames have no counterpart\n";
    text += "\n";
  }
  return text;
}

nlohmann::json difference_json(const Difference& apart) {
  nlohmann::json frames = nlohmann::json::array();
  for (const FrameDifference& frame : apart.frames)
    frames.push_back({{"time", frame.time},
                      {"position", frame.position},
                      {"velocity", frame.velocity},
                      {"spin", frame.spin}});
  nlohmann::json scalars = nlohmann::json::object();
  for (const auto& [name, values] : apart.scalars) scalars[name] = {values.first, values.second};
  return {{"first", apart.first},
          {"second", apart.second},
          {"length_scale", apart.scale.length},
          {"speed_scale", apart.scale.speed},
          {"frames", frames},
          {"unmatched_frames", apart.unmatched},
          {"scalars", scalars}};
}

}  // namespace grainproof::report
