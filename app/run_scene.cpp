// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_scene.hpp"

#include <optional>

#include "app/drive.hpp"
#include "app/engines.hpp"
#include "app/exit_code.hpp"
#include "app/resources.hpp"
#include "app/scene_choice.hpp"
#include "app/scene_identity.hpp"
#include "app/self_test.hpp"
#include "model/errors.hpp"
#include "report/files.hpp"
#include "report/frames.hpp"
#include "report/numbers.hpp"
#include "report/run_summary.hpp"
#include "report/walls_csv.hpp"

namespace grainproof::app {
namespace {

/// From here on a ledger costs as much as the run itself: opencl/dense_options.hpp has no room for one.
constexpr std::size_t too_many_for_a_ledger = 512;

/// Where it is asked for, costs next to nothing, is what the case is about, or was kept so far.
bool ledger_wanted(const RunOptions& options, const ChosenScene& chosen,
                   const std::optional<report::SavedCheckpoint>& saved) {
  if (options.ledger || options.no_ledger) return options.ledger;
  return chosen.scene.particles.size() < too_many_for_a_ledger || chosen.claims_ledger ||
         (saved && saved->checkpoint.ledger);
}

Support keeps_ledger(const Engine& engine, const Scene& scene) {
  Request request;
  request.ledger = true;
  return engine.supports(scene, request);
}

/// With the energy ledger where it is wanted and the engine can keep one. Throws InputRefused where it
/// cannot run at all, or not with the ledger that was asked for outright.
Request supported_request(const Engine& engine, const Scene& scene, bool wanted, bool insisted) {
  if (const Support support = engine.supports(scene, {}); !support)
    throw InputRefused(engine.name() + " does not support this scene: " + support.because);
  Request request;
  if (!wanted) return request;
  const Support support = keeps_ledger(engine, scene);
  if (!support && insisted) throw InputRefused(engine.name() + " keeps no ledger of it: " + support.because);
  request.ledger = support.yes;
  return request;
}

/// The checkpoint to go on from, which must be of this scene and not beyond its end.
std::optional<report::SavedCheckpoint> saved_run(const RunOptions& options, const ChosenScene& chosen) {
  if (options.from.empty()) return {};
  report::SavedCheckpoint saved = report::read_checkpoint(options.from);
  report::require_same_scene(options.from, saved.origin, chosen.name, fingerprints_of(chosen.scene));
  const RunSettings& run = chosen.scene.run;
  if (saved.checkpoint.state.step > step_at_or_after(run.end, run.step))
    throw InputRefused(options.from.string() + " is of t = " + report::exact(saved.checkpoint.state.time) +
                       " s, and the scene ends at " + report::exact(run.end) + " s");
  return saved;
}

KeeperOptions keeper_options(const RunOptions& options) {
  KeeperOptions keeper{.sentinels = !options.no_sentinels, .folder = options.out};
  if (options.checkpoint_every.empty()) return keeper;
  read_interval(options.checkpoint_every, keeper);
  if (options.out.empty())
    throw InputRefused("found --checkpoint-every without --out; expected a folder to write checkpoints to");
  return keeper;
}

/// Says so where a run cannot go on with the bits of the one before.
void say_how_it_goes_on(Engine& engine, const Scene& scene, const Request& request,
                        const report::SavedCheckpoint& saved, Progress& progress) {
  auto* restartable = dynamic_cast<RestartableEngine*>(&engine);
  if (restartable == nullptr) return;
  const State& state = saved.checkpoint.state;
  const std::string because = restartable->resume(scene, request, saved.checkpoint).not_exact_because;
  progress.say("goes on from step " + std::to_string(state.step) + ", t = " + report::exact(state.time) +
               " s" + (because.empty() ? "" : "; not with the bits of the run before: " + because));
}

report::RunSummary summarise(const ChosenScene& chosen, const Driven& seen, std::int64_t frames) {
  report::RunSummary summary;
  summary.scene = chosen.name;
  summary.particles = static_cast<std::int64_t>(chosen.scene.particles.size());
  summary.frames = frames;
  summary.step = chosen.scene.run.step;
  summary.step_because = chosen.step_because;
  summary.first_step = seen.first_step;
  summary.digest = seen.digest;
  if (!seen.frames.empty())
    summary.last_energies = report::energies_of(chosen.scene, seen.frames.back(), summary.contacts);
  summary.peak_memory = report::peak_memory_bytes();
  return summary;
}

report::CheckpointOrigin origin_of(const Engine& engine, const ChosenScene& chosen) {
  report::CheckpointOrigin origin;
  origin.scene = chosen.name;
  origin.parts = fingerprints_of(chosen.scene);
  if (const auto* stepping = dynamic_cast<const SteppingEngine*>(&engine))
    origin.provenance = stepping->provenance();
  return origin;
}

void explain_failure(const Outcome& outcome, std::ostream& err) {
  err << "grainproof: the run went wrong at t = " << report::exact(outcome.time) << " s, step "
      << outcome.step << ": " << outcome.reason << std::endl;
}

void say_what_is_written(const RunOptions& options, std::int64_t frames, bool walls, std::ostream& out) {
  if (options.out.empty()) return;
  out << "  written        in " << options.out.string() << ": summary.json, " << report::grouped(frames)
      << " frames (frames.pvd opens them in ParaView)" << (walls ? ", walls.csv" : "")
      << (options.csv ? ", frames.csv" : "") << "\n";
}

}  // namespace

int run_scene(const RunOptions& options, Terminal& terminal) {
  Progress progress(terminal.err, terminal.err_is_terminal, terminal.quiet);
  const auto data = data_root();
  const auto engine = make_engine(options.engine, {data, options.precision, options.device});
  const ChosenScene chosen = choose_scene(data, options.scene, options.nth, options.force, progress);
  const KeeperOptions kept = keeper_options(options);
  const auto saved = saved_run(options, chosen);
  const bool wanted = ledger_wanted(options, chosen, saved);
  const Request request = supported_request(*engine, chosen.scene, wanted, options.ledger);
  if (!options.no_self_test)
    require_sound_kernels({*engine, chosen.scene, request}, data, options.device, progress);
  if (saved) say_how_it_goes_on(*engine, chosen.scene, request, *saved, progress);
  RunKeeper keeper(chosen.scene, kept, origin_of(*engine, chosen));

  std::optional<report::FrameWriter> writer;
  if (!options.out.empty()) writer.emplace(options.out, chosen.scene, options.csv);
  std::optional<report::WallWriter> walls;
  if (writer && request.ledger && !chosen.scene.walls.empty()) walls.emplace(options.out, chosen.scene);
  std::int64_t frames = 0;
  std::optional<report::Energies> first;
  const Driven seen = drive(*engine, chosen.scene, request, progress,
                            [&](const Frame& frame, const Ledger* ledger) {
                              if (writer) writer->write(frame);
                              if (walls && ledger) walls->write(frame.time, *ledger);
                              if (frames++ == 0) first = report::energies_of(chosen.scene, frame);
                            },
                            {saved ? &saved->checkpoint : nullptr, &keeper});

  report::RunSummary summary = summarise(chosen, seen, frames);
  summary.first_energies = first;
  if (!wanted && !options.no_ledger && keeps_ledger(*engine, chosen.scene))
    summary.no_ledger_because = "none of so many particles, for speed; --ledger keeps one";
  const std::string json = report::summary_json(summary, seen, report::this_machine()).dump(2) + "\n";
  if (!options.out.empty()) report::write_file(options.out / "summary.json", json);
  if (!options.json.empty()) report::write_file(options.json, json);
  terminal.out << report::summary_text(summary, seen, terminal.paint());
  say_what_is_written(options, frames, walls.has_value(), terminal.out);
  if (seen.outcome.status == Outcome::Status::completed) return all_held;
  explain_failure(seen.outcome, terminal.err);
  return run_went_wrong;
}

}  // namespace grainproof::app
