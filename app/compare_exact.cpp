// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare_exact.hpp"

#include <nlohmann/json.hpp>

#include "app/engines.hpp"
#include "app/exit_code.hpp"
#include "app/first_difference.hpp"
#include "app/resources.hpp"
#include "app/scene_choice.hpp"
#include "model/errors.hpp"
#include "report/files.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

std::unique_ptr<Engine> stepping_engine(const std::string& name, const CompareOptions& options,
                                        const Scene& scene) {
  auto engine = make_engine(name, {data_root(), "", options.device});
  if (dynamic_cast<SteppingEngine*>(engine.get()) == nullptr)
    throw InputRefused(name + " does not go step by step, so it has no bits to compare");
  if (const Support support = engine->supports(scene, {}); !support)
    throw InputRefused(name + " does not support this scene: " + support.because);
  return engine;
}

nlohmann::json json_of(const std::string& one, const std::string& other, std::int64_t last,
                       const std::optional<BitDifference>& found) {
  nlohmann::json json{{"schema", 1}, {"first", one}, {"second", other}, {"steps", last}, {"same", !found}};
  json["differs"] = nullptr;
  if (found)
    json["differs"] = {{"step", found->step},          {"time", found->time},   {"particle", found->particle},
                       {"what", found->what},          {"first", found->first}, {"second", found->second},
                       {"particles", found->particles}};
  return json;
}

void tell(const std::string& one, const std::string& other, std::int64_t last,
          const std::optional<BitDifference>& found, std::ostream& out) {
  if (!found) {
    out << one << " and " << other << ": the same bits over " << report::grouped(last) << " steps\n";
    return;
  }
  out << one << " and " << other << " first differ at step " << found->step
      << ", t = " << report::exact(found->time) << " s, in " << found->particles
      << (found->particles == 1 ? " particle\n" : " particles\n") << "  particle " << found->particle << ", "
      << found->what << ": " << report::exact(found->first) << " and " << report::exact(found->second)
      << ", apart by " << report::brief(found->second - found->first) << "\n";
}

}  // namespace

int compare_exact(const CompareOptions& options, Terminal& terminal) {
  Progress progress(terminal.err, terminal.err_is_terminal, terminal.quiet);
  if (!options.engines.empty()) throw InputRefused("found --engines and --exact; expected one of them");
  if (options.exact.size() > 2 || (options.exact.size() == 1 && options.other.empty()))
    throw InputRefused("--exact expects two engines, or one and --other SCENE");
  const auto data = data_root();
  const ChosenScene first = choose_scene(data, options.scene, options.nth, options.force, progress);
  const ChosenScene second =
      options.other.empty() ? first : choose_scene(data, options.other, options.nth, options.force, progress);
  const auto one = stepping_engine(options.exact.front(), options, first.scene);
  const auto other = stepping_engine(options.exact.back(), options, second.scene);
  const std::int64_t last = step_at_or_after(first.scene.run.end, first.scene.run.step);
  const std::string name = one->name() + (options.other.empty() ? "" : " with " + first.name);
  const std::string other_name = other->name() + (options.other.empty() ? "" : " with " + second.name);
  const auto found = first_difference(
      {dynamic_cast<SteppingEngine&>(*one), first.scene},
      {dynamic_cast<SteppingEngine&>(*other), second.scene}, last, [&](std::int64_t step) {
        progress.show("step " + report::grouped(step), static_cast<double>(step) / static_cast<double>(last));
      });
  progress.clear();
  const std::string json = json_of(name, other_name, last, found).dump(2) + "\n";
  if (!options.out.empty()) report::write_file(options.out / "compare.json", json);
  if (!options.json.empty()) report::write_file(options.json, json);
  tell(name, other_name, last, found, terminal.out);
  return found ? verdict_failed : all_held;
}

}  // namespace grainproof::app
