// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/one_input.hpp"

#include <algorithm>

#include "input/read_case.hpp"
#include "model/errors.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "tests/fuzz/constraints.hpp"

namespace grainproof::fuzz {
namespace {

/// A changed digit may ask for anything: it is to be refused rather than served.
constexpr ReadOptions modest{.force = false, .most_scenes = 200, .most_particles = 200};
constexpr double few_steps = 5.0;

bool finite(const Frame& frame) {
  const auto all = [](const std::vector<Vec3>& vectors) {
    return std::all_of(vectors.begin(), vectors.end(), [](const Vec3& v) { return v.allFinite(); });
  };
  return all(frame.position) && all(frame.velocity) && all(frame.angular_velocity);
}

/// Some steps on the reference, which says so where it goes wrong.
std::string complaint_about_run(Scene scene) {
  reference::ReferenceEngine engine;
  if (!engine.supports(scene, {})) return "";
  scene.run.end = std::min(scene.run.end, few_steps * scene.run.step);
  scene.run.sample_times = {0.0, scene.run.end};
  const Observations seen = engine.observe(scene, {});
  if (seen.outcome.status == Outcome::Status::went_wrong)
    return seen.outcome.reason.empty() ? "a run that went wrong without a reason" : "";
  return std::all_of(seen.frames.begin(), seen.frames.end(), finite) ? ""
                                                                     : "a run with a number that is none";
}

std::string complaint_about_refusal(const std::string& message) {
  const bool placed = message.starts_with("scene.toml:") || message.starts_with("/dev/null:");
  return placed && message.find(": found ") != std::string::npos &&
                 message.find("; expected ") != std::string::npos
             ? ""
             : "a refusal without a place or a reason: " + message;
}

}  // namespace

Judged judge(const std::string& text, bool run) try {
  const Case read = read_case_text(text, "scene.toml", modest);
  if (const std::string broken = broken_constraint(read, modest); !broken.empty())
    return {Answer::read, "accepted, though it breaks: " + broken};
  if (!read.refused.empty()) return {Answer::refused, complaint_about_refusal(read.refused)};
  return {Answer::read, run ? complaint_about_run(read.scenes.front().scene) : ""};
} catch (const InputRefused& refused) {
  return {Answer::refused, complaint_about_refusal(refused.what())};
} catch (const std::exception& other) {
  return {Answer::read, std::string("neither read nor refused: ") + other.what()};
}

}  // namespace grainproof::fuzz
