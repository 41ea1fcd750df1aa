// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/external/frames_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "comparisons/peers/folded.hpp"
#include "model/errors.hpp"

namespace grainproof::external {
namespace {

constexpr const char* columns_without_rotation = "time,id,x,y,z,vx,vy,vz";
constexpr const char* columns_with_rotation = "time,id,x,y,z,vx,vy,vz,wx,wy,wz";
constexpr std::size_t most_columns = 11;
constexpr double same_time = 1e-6;  // of a step; a time printed in decimals need not be the very number

[[noreturn]] void complain(const std::string& what) {
  throw EngineFailed("frames.csv: " + what);
}

std::string without_return(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

using Row = std::array<double, most_columns>;

const char* columns_of(const Scene& scene) {
  return scene.rotation ? columns_with_rotation : columns_without_rotation;
}

Row numbers_of(const std::string& line, int number, const Scene& scene) {
  const std::size_t count = scene.rotation ? most_columns : most_columns - 3;
  Row values{};
  const char* at = line.c_str();
  for (std::size_t column = 0; column < count; ++column) {
    char* end = nullptr;
    values[column] = std::strtod(at, &end);
    const char expected = column + 1 < count ? ',' : '\0';
    if (end == at || *end != expected)
      complain("line " + std::to_string(number) + ": expected " + columns_of(scene) + ", found " + line);
    at = end + 1;
  }
  return values;
}

/// Frames under construction, by step.
class Collector {
 public:
  Collector(const Scene& scene, const std::vector<std::int64_t>& steps) : scene_(scene) {
    for (std::size_t i = 0; i < scene.particles.size(); ++i) index_[scene.particles[i].id] = i;
    for (const std::int64_t step : steps) frames_[step];
  }

  void add(const Row& row, int line) {
    const double steps = row[0] / scene_.run.step;
    const auto wanted = frames_.find(std::isfinite(steps) ? std::llround(steps) : -1);
    if (wanted == frames_.end() || std::abs(steps - std::round(steps)) > same_time) return;
    const auto particle = index_.find(std::llround(row[1]));
    if (particle == index_.end()) complain("line " + std::to_string(line) + ": no particle has this id");
    if (!wanted->second.emplace(particle->second, row).second)
      complain("line " + std::to_string(line) + ": this particle is already in the frame");
  }

  Observations observations() const {
    Observations seen;
    for (const auto& [step, rows] : frames_) {
      if (rows.size() != scene_.particles.size()) complain(shortage(step, rows.size()));
      Frame frame{step, static_cast<double>(step) * scene_.run.step, {}, {}};
      for (const auto& [particle, row] : rows) {
        frame.position.push_back(folded(Vec3(row[2], row[3], row[4]), scene_.domain));
        frame.velocity.emplace_back(row[5], row[6], row[7]);
        if (scene_.rotation) frame.angular_velocity.emplace_back(row[8], row[9], row[10]);
        if (std::all_of(row.begin(), row.end(), [](double number) { return std::isfinite(number); }))
          continue;
        const std::int64_t id = scene_.particles[particle].id;
        seen.outcome = {Outcome::Status::went_wrong,
                        "particle " + std::to_string(id) + " has a number that is not finite",
                        step,
                        frame.time,
                        {id}};
        return seen;
      }
      seen.frames.push_back(std::move(frame));
    }
    seen.counters.steps = seen.frames.back().step;
    return seen;
  }

 private:
  std::string shortage(std::int64_t step, std::size_t found) const {
    std::ostringstream text;
    text.precision(9);
    text << "the frame at " << static_cast<double>(step) * scene_.run.step << " s (step " << step << ") ";
    if (found == 0)
      text << "is missing";
    else
      text << "has " << found << " of " << scene_.particles.size() << " particles";
    return text.str();
  }

  const Scene& scene_;
  std::map<std::int64_t, std::size_t> index_;
  std::map<std::int64_t, std::map<std::size_t, Row>> frames_;
};

}  // namespace

Observations read_frames(const std::filesystem::path& file, const Scene& scene,
                         const std::vector<std::int64_t>& steps) {
  std::ifstream in(file);
  if (!in) complain("the command did not write it");
  std::string line;
  std::getline(in, line);
  if (without_return(line) != columns_of(scene))
    complain("expected the columns " + std::string(columns_of(scene)) + ", found " + line);
  Collector frames(scene, steps);
  for (int number = 2; std::getline(in, line); ++number)
    if (const std::string row = without_return(line); !row.empty())
      frames.add(numbers_of(row, number, scene), number);
  return frames.observations();
}

}  // namespace grainproof::external
