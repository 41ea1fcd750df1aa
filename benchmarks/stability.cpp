// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>

#include "benchmarks/common/long_run.hpp"
#include "benchmarks/common/row_table.hpp"
#include "benchmarks/common/settling.hpp"
#include "benchmarks/common/stability_map.hpp"
#include "benchmarks/common/stability_meter.hpp"
#include "benchmarks/common/subject.hpp"
#include "report/numbers.hpp"

namespace grainproof::bench {
namespace {

/// All there is of this program: the rows' table and what measures them, in the order in which they may go.
struct Map {
  explicit Map(const Settings& of)
      : settings(of),
        meter(of),
        table("stability", of.cache / "stability" / (of.quick ? "quick.jsonl" : "full.jsonl"),
              program_stamp(of.data / "kernels") + " on " + (of.device.empty() ? "any device" : of.device)) {}

  const Settings& settings;
  StabilityMeter meter;
  RowTable table;
};

/// A filter leaves out rows that the table does not know to be left out: none is measured ahead then.
std::size_t threads_for(const Settings& settings) {
  const std::string filter = benchmark::GetBenchmarkFilter();
  const bool everything = filter.empty() || filter == "." || filter == "all";
  return everything ? static_cast<std::size_t>(thread_count(settings)) : 0;
}

void show(benchmark::State& state, const MeasuredRow& row) {
  for (auto _ : state) state.SetIterationTime(1.0);
  if (!row.failed.empty()) return state.SkipWithError(row.failed.c_str());
  for (const auto& [name, value] : row.values) state.counters[name] = value;
}

void add_row(const std::shared_ptr<Map>& map, const std::string& name, double weight,
             const std::function<MeasuredRow()>& measure) {
  const std::size_t row = map->table.add({name, weight, measure});
  add_manual("stability/" + name + "/round:0", [map, row](benchmark::State& state) {
    show(state, map->table.show(row, threads_for(map->settings)));
  });
}

void add_limits(const std::shared_ptr<Map>& map, const StabilityCase& of) {
  StabilityMeter& meter = map->meter;
  for (const std::string& engine : map->settings.engines)
    for (const auto& [name, integrator] : integrator_names) {
      if (integrator == Integrator::euler_trapezoid_implicit_drag && of.arrangement != "pair")
        continue;  // without drag the same as explicit
      if (engine == "reference" || is_representative(of, map->settings.quick))
        add_row(map, name_of(of, engine_key(engine), std::string(name)), weight_of(of, engine),
                [&meter, engine, integrator, of] { return meter.limit(engine, integrator, of); });
    }
}

void add_settling(const std::shared_ptr<Map>& map, const std::string& engine, double end) {
  StabilityMeter& meter = map->meter;
  for (const Integrator integrator : {Integrator::euler_trapezoid, Integrator::velocity_verlet})
    for (const double step : settling_steps(map->settings.quick))
      add_row(map,
              "scene:settling/" + engine_key(engine) + "/integrator:" + std::string(name_of(integrator)) +
                  "/step:" + report::exact(step) + "/end:" + report::exact(end),
              1.0, [&meter, engine, integrator, step, end] {
                return meter.settled(engine, integrator, step, end);
              });
}

void add(const Settings& settings) {
  const auto map = std::make_shared<Map>(settings);
  const auto asked_for = [&](const std::string& scene) {
    return settings.scenes.empty() || std::ranges::find(settings.scenes, scene) != settings.scenes.end();
  };
  for (const StabilityCase& of : stability_map(settings.quick))
    if (asked_for(of.arrangement)) add_limits(map, of);
  if (!asked_for("settling")) return;
  for (const std::string& engine : settings.engines)
    for (const double end : settings.quick ? std::vector<double>{1.0} : std::vector<double>{1.0, 20.0})
      add_settling(map, engine, end);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
