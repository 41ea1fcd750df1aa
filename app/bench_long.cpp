// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_long.hpp"

#include <algorithm>
#include <array>

namespace grainproof::app {
namespace {

/// Bodies of each scene, so that --most leaves out what is larger.
struct LongScene {
  const char* name;
  std::int64_t particles;
};
constexpr std::array scenes{LongScene{"bounces", 2}, LongScene{"pile", 50}, LongScene{"vibrated", 1000}};

std::vector<std::string> scenes_within(const BenchOptions& options) {
  std::vector<std::string> names;
  for (const LongScene& one : scenes)
    if (one.particles >= options.least && (options.most == 0 || one.particles <= options.most))
      names.emplace_back(one.name);
  if (names.empty()) names.emplace_back("bounces");
  return names;
}

}  // namespace

void measure_long(BenchSession& session) {
  session.run({.suite = "long",
               .what = "drift in long runs",
               .scenes = scenes_within(session.options()),
               .engines = session.engines(),
               .rounds = 1});
}

void add_verdicts(nlohmann::json& rows) {
  for (nlohmann::json& row : rows)
    if (row.contains("held")) row["verdict"] = row.at("held").get<double>() > 0.5 ? "held" : "NOT HELD";
}

}  // namespace grainproof::app
