// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/peers/dump.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "comparisons/peers/folded.hpp"
#include "model/errors.hpp"

namespace grainproof::peers {
namespace {

/// Walks over the numbers and lines of a dump held in memory.
class Text {
 public:
  explicit Text(std::string content) : content_(std::move(content)), at_(content_.c_str()) {}

  bool next_line_is(const std::string& wanted) {
    if (std::string_view(at_).substr(0, wanted.size()) != wanted) return false;
    skip_line();
    return true;
  }
  void skip_line() {
    while (*at_ && *at_ != '\n') ++at_;
    if (*at_) ++at_;
  }
  double number() {
    char* end = nullptr;
    const double value = std::strtod(at_, &end);
    if (end == at_) throw EngineFailed("a dump with a line that is no row of numbers");
    at_ = end;
    return value;
  }
  bool ended() const { return *at_ == '\0'; }

 private:
  std::string content_;
  const char* at_;
};

struct RawFrame {
  Frame frame;
  std::vector<bool> present;
};

void read_row(Text& text, const Domain& domain, RawFrame& raw) {
  const auto id = static_cast<std::size_t>(text.number());
  if (id < 1 || id > raw.present.size()) throw EngineFailed("a dump with an unknown particle");
  Vec3& x = raw.frame.position[id - 1];
  Vec3& v = raw.frame.velocity[id - 1];
  for (int axis = 0; axis < 3; ++axis) x[axis] = text.number();
  for (int axis = 0; axis < 3; ++axis) v[axis] = text.number();
  if (!raw.frame.angular_velocity.empty())
    for (int axis = 0; axis < 3; ++axis) raw.frame.angular_velocity[id - 1][axis] = text.number();
  x = folded(x, domain);
  raw.present[id - 1] = true;
  text.skip_line();
}

RawFrame read_frame(Text& text, const Scene& scene) {
  if (!text.next_line_is("ITEM: TIMESTEP")) throw EngineFailed("a dump without a time step");
  const std::size_t count = scene.particles.size();
  RawFrame raw;
  raw.frame.position.assign(count, Vec3::Zero());
  raw.frame.velocity.assign(count, Vec3::Zero());
  if (scene.rotation) raw.frame.angular_velocity.assign(count, Vec3::Zero());
  raw.present.assign(count, false);
  raw.frame.step = static_cast<std::int64_t>(text.number());
  raw.frame.time = static_cast<double>(raw.frame.step) * scene.run.step;
  text.skip_line();
  text.skip_line();
  const auto rows = static_cast<std::size_t>(text.number());
  for (int line = 0; line < 6; ++line) text.skip_line();
  for (std::size_t row = 0; row < rows; ++row) read_row(text, scene.domain, raw);
  return raw;
}

std::optional<Outcome> fault_in(const RawFrame& raw, const Scene& scene) {
  for (std::size_t i = 0; i < raw.present.size(); ++i) {
    const bool turns = !raw.frame.angular_velocity.empty();
    const bool sound = raw.frame.position[i].allFinite() && raw.frame.velocity[i].allFinite() &&
                       (!turns || raw.frame.angular_velocity[i].allFinite());
    if (raw.present[i] && sound) continue;
    const std::string what =
        raw.present[i] ? " has a position, velocity or spin that is no number" : " has left the domain";
    const std::int64_t id = scene.particles[i].id;
    return Outcome{Outcome::Status::went_wrong,
                   "particle " + std::to_string(id) + what,
                   raw.frame.step,
                   raw.frame.time,
                   {id}};
  }
  return std::nullopt;
}

Observations read_frames(Text& text, const Scene& scene, const std::vector<std::int64_t>& steps) {
  Observations seen;
  for (const std::int64_t step : steps) {
    RawFrame raw = read_frame(text, scene);
    if (raw.frame.step != step) throw EngineFailed("a dump without step " + std::to_string(step));
    if (const auto fault = fault_in(raw, scene)) {
      seen.outcome = *fault;
      break;
    }
    seen.frames.push_back(std::move(raw.frame));
  }
  seen.counters.steps = seen.frames.empty() ? 0 : seen.frames.back().step;
  return seen;
}

}  // namespace

Observations read_dump(const std::filesystem::path& file, const Scene& scene,
                       const std::vector<std::int64_t>& steps, const std::string& program) {
  std::ifstream in(file);
  if (!in) throw EngineFailed(program + " wrote no dump");
  Text text({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()});
  try {
    return read_frames(text, scene, steps);
  } catch (const EngineFailed& failure) {
    throw EngineFailed(program + ": " + failure.what());
  }
}

}  // namespace grainproof::peers
