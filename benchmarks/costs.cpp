// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "benchmarks/common/cost_pair.hpp"
#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"
#include "model/integrators.hpp"

namespace grainproof::bench {
namespace {

/// The zoned path takes a tenth of the dense one's speed: its scenes need not be as large.
constexpr std::int64_t most_zoned = 10000;

/// One thing that may cost no more than a share of the time of a step without it.
struct Cost {
  const char* name;
  const char* scene;
  double bar;          ///< 0.02 is two per cent
  bool zoned = false;  ///< both on the zoned path: the dense one has it not, or for nothing
};

constexpr std::array costs{
    Cost{"sentinels", "bed", 0.02},       Cost{"onset_corrected", "bed", 0.10},
    Cost{"onset_corrected", "gas", 0.15}, Cost{"ledger", "bed", 0.10, true},
    Cost{"ledger", "gas", 0.10, true},    Cost{"mixed", "bed", 0.25, true},
    Cost{"mixed", "gas", 0.25, true},     Cost{"canonical", "bed", 0.25},
    Cost{"canonical", "gas", 0.25},
};

bool is(const Cost& cost, std::string_view name) {
  return cost.name == name;
}

/// What a scene takes that names nothing, and with the cost in question.
CostSide side_of(const Cost& cost, const std::string& engine, bool with, const Settings& settings) {
  CostSide side;
  side.engine = is(cost, "mixed") && with ? "opencl:mixed" : engine;
  side.ledger = is(cost, "ledger") && with;
  side.sentinels = is(cost, "sentinels") && with;
  side.zoned = cost.zoned;
  const bool canonical = is(cost, "canonical") && with;
  const Integrator integrator =
      is(cost, "onset_corrected") && !with ? Integrator::velocity_verlet : usual_integrator;
  side.scene = [=, name = std::string(cost.scene), cache = settings.cache](std::int64_t particles) {
    Scene scene = scene_named(name, particles, cache);
    scene.run.integrator = integrator;
    scene.run.order = canonical ? SumOrder::canonical : SumOrder::fast;
    return scene;
  };
  return side;
}

/// ABBA: what a machine loses from one measurement to the next is lost by both alike.
void add_cost(const Cost& cost, const std::string& engine, const Settings& settings) {
  const std::int64_t asked = settings.particles.at(0);
  const std::int64_t particles = cost.zoned ? std::min(asked, most_zoned) : asked;
  const std::array sides{side_of(cost, engine, false, settings), side_of(cost, engine, true, settings)};
  const auto pair = std::make_shared<CostPair>(sides[0], sides[1], particles, cost.bar, settings);
  for (int round = 0; round < settings.rounds; ++round)
    for (const bool with : {round % 2 == 1, round % 2 == 0})
      add_manual("costs/scene:" + sized_name(cost.scene, particles) + "/" +
                     engine_key(sides[with ? 1 : 0].engine) + "/cost:" + cost.name +
                     "/with:" + (with ? "yes" : "no") + "/round:" + std::to_string(round),
                 [pair, with](benchmark::State& state) { pair->measure(state, with); });
}

void add(const Settings& settings) {
  for (const Cost& cost : costs)
    for (const std::string& engine : settings.engines)
      if (!is(cost, "mixed") || engine == "opencl:single") add_cost(cost, engine, settings);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
