// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare.hpp"

#include <algorithm>

#include "app/compare_exact.hpp"
#include "app/drive.hpp"
#include "app/engines.hpp"
#include "app/exit_code.hpp"
#include "app/resources.hpp"
#include "app/scene_choice.hpp"
#include "model/errors.hpp"
#include "report/files.hpp"
#include "report/frames.hpp"
#include "report/numbers.hpp"
#include "report/run_summary.hpp"
#include "report/side_by_side.hpp"

namespace grainproof::app {
namespace {

/// Those of the engines asked for that are here and support the scene; `progress` says why others are not.
std::vector<std::unique_ptr<Engine>> engines_for(const CompareOptions& options,
                                                 const std::filesystem::path& data, const Scene& scene,
                                                 Progress& progress) {
  std::vector<std::unique_ptr<Engine>> engines;
  const std::vector<std::string> usual{"reference", "opencl"};
  for (const std::string& name : options.engines.empty() ? usual : options.engines)
    for (Made& made : make_engines(name, {data, "", options.device})) {
      if (!made.engine) {
        progress.say(made.name + " is not available: " + made.because);
      } else if (const Support support = made.engine->supports(scene, {}); !support) {
        progress.say(made.name + " does not support this scene: " + support.because);
      } else {
        engines.push_back(std::move(made.engine));
      }
    }
  if (engines.size() < 2)
    throw InputRefused("compare needs two engines that can run the scene, found " +
                       (engines.empty() ? "none" : "only " + engines.front()->name()) +
                       "; expected --engines A,B");
  return engines;
}

/// An engine's name as a folder: what a path could trip over becomes a dash.
std::string folder_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '_'; }, '-');
  return name;
}

report::Seen see(Engine& engine, const Scene& scene, Progress& progress, const CompareOptions& options) {
  progress.say(engine.name() + " …");
  report::Seen seen{engine.name(), {}};
  std::vector<Frame> frames;
  seen.observations =
      drive(engine, scene, {}, progress, [&](const Frame& frame, const Ledger*) { frames.push_back(frame); });
  seen.observations.frames = std::move(frames);
  if (options.out.empty()) return seen;
  report::FrameWriter writer(options.out / folder_name(seen.engine), scene, true);
  for (const Frame& frame : seen.observations.frames) writer.write(frame);
  return seen;
}

nlohmann::json compare_json(const std::string& scene, const std::vector<report::Seen>& seen,
                            const std::vector<report::Difference>& differences) {
  nlohmann::json engines = nlohmann::json::array();
  for (const report::Seen& one : seen) {
    engines.push_back(report::provenance_json(one.observations.provenance));
    engines.back()["name"] = one.engine;
    engines.back()["wall_s"] = one.observations.wall_s;
  }
  nlohmann::json apart = nlohmann::json::array();
  for (const report::Difference& one : differences) apart.push_back(report::difference_json(one));
  return {{"schema", 1},
          {"scene", scene},
          {"machine", report::machine_json(report::this_machine())},
          {"engines", engines},
          {"differences", apart}};
}

int report_failures(const std::vector<report::Seen>& seen, std::ostream& err) {
  int code = all_held;
  for (const report::Seen& one : seen) {
    const Outcome& outcome = one.observations.outcome;
    if (outcome.status == Outcome::Status::completed) continue;
    err << "grainproof: on " << one.engine << " the run went wrong at t = " << report::exact(outcome.time)
        << " s, step " << outcome.step << ": " << outcome.reason << std::endl;
    code = run_went_wrong;
  }
  return code;
}

}  // namespace

int compare(const CompareOptions& options, Terminal& terminal) {
  if (!options.exact.empty()) return compare_exact(options, terminal);
  Progress progress(terminal.err, terminal.err_is_terminal, terminal.quiet);
  const auto data = data_root();
  const ChosenScene chosen = choose_scene(data, options.scene, options.nth, options.force, progress);
  std::vector<report::Seen> seen;
  for (const auto& engine : engines_for(options, data, chosen.scene, progress))
    seen.push_back(see(*engine, chosen.scene, progress, options));
  std::vector<report::Difference> differences;
  for (std::size_t i = 1; i < seen.size(); ++i)
    differences.push_back(report::difference(chosen.scene, seen.front(), seen[i]));

  const std::string json = compare_json(chosen.name, seen, differences).dump(2) + "\n";
  if (!options.out.empty()) report::write_file(options.out / "compare.json", json);
  if (!options.json.empty()) report::write_file(options.json, json);
  terminal.out << report::difference_text(differences, terminal.paint());
  return report_failures(seen, terminal.err);
}

}  // namespace grainproof::app
