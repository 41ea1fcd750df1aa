// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_scene.hpp"

#include <optional>

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
#include "report/walls_csv.hpp"

namespace grainproof::app {
namespace {

/// With the energy ledger where it is wanted and the engine can keep one. Throws InputRefused where it
/// cannot run at all.
Request supported_request(const Engine& engine, const Scene& scene, bool no_ledger) {
  if (const Support support = engine.supports(scene, {}); !support)
    throw InputRefused(engine.name() + " does not support this scene: " + support.because);
  Request request;
  if (no_ledger) return request;
  request.ledger = true;
  request.ledger = engine.supports(scene, request).yes;
  return request;
}

report::RunSummary summarise(const ChosenScene& chosen, const Observations& seen, std::int64_t frames) {
  report::RunSummary summary;
  summary.scene = chosen.name;
  summary.particles = static_cast<std::int64_t>(chosen.scene.particles.size());
  summary.frames = frames;
  summary.step = chosen.scene.run.step;
  summary.step_because = chosen.step_because;
  if (!seen.frames.empty()) summary.contacts = report::count_contacts(chosen.scene, seen.frames.back());
  summary.peak_memory = report::peak_memory_bytes();
  return summary;
}

void explain_failure(const Outcome& outcome, std::ostream& err) {
  err << "grainproof: the run went wrong at t = " << report::exact(outcome.time) << " s, step "
      << outcome.step;
  if (!outcome.particles.empty()) {
    err << ", particle" << (outcome.particles.size() > 1 ? "s" : "");
    for (std::int64_t id : outcome.particles) err << " " << id;
  }
  err << ": " << outcome.reason << std::endl;
}

}  // namespace

int run_scene(const RunOptions& options, Terminal& terminal) {
  Progress progress(terminal.err, terminal.err_is_terminal, terminal.quiet);
  const auto data = data_root();
  const auto engine = make_engine(options.engine, {data, options.precision, options.device});
  const ChosenScene chosen = choose_scene(data, options.scene, options.nth, options.force, progress);
  const Request request = supported_request(*engine, chosen.scene, options.no_ledger);

  std::optional<report::FrameWriter> writer;
  if (!options.out.empty()) writer.emplace(options.out, chosen.scene, options.csv);
  std::optional<report::WallWriter> walls;
  if (writer && request.ledger && !chosen.scene.walls.empty()) walls.emplace(options.out, chosen.scene);
  std::int64_t frames = 0;
  const Observations seen =
      drive(*engine, chosen.scene, request, progress, [&](const Frame& frame, const Ledger* ledger) {
        if (writer) writer->write(frame);
        if (walls && ledger) walls->write(frame.time, *ledger);
        ++frames;
      });

  const report::RunSummary summary = summarise(chosen, seen, frames);
  const std::string json = report::summary_json(summary, seen, report::this_machine()).dump(2) + "\n";
  if (!options.out.empty()) report::write_file(options.out / "summary.json", json);
  if (!options.json.empty()) report::write_file(options.json, json);
  terminal.out << report::summary_text(summary, seen, terminal.paint());
  if (seen.outcome.status == Outcome::Status::completed) return all_held;
  explain_failure(seen.outcome, terminal.err);
  return run_went_wrong;
}

}  // namespace grainproof::app
