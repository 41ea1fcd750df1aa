// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <map>
#include <utility>

#include "app/engines.hpp"
#include "benchmarks/common/exact_solution.hpp"
#include "benchmarks/common/known_errors.hpp"
#include "benchmarks/common/pair_peer.hpp"
#include "benchmarks/common/peer_subject.hpp"
#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

constexpr std::size_t worth_timing = 1000;  ///< particles of a scene whose time says something

/// One curve of a picture.
struct Contestant {
  std::string key;  ///< of its rows
  std::string engine;
  Integrator integrator;
};

struct Point {
  const AccuracyScene& scene;
  double steps_per_contact;
};

/// Errors are the same each time. Only of a gas of many pairs, and of what is no gas of pairs, is the time
/// compared; all else is measured once, and no peer is tuned for it.
bool is_timed(const AccuracyScene& of) {
  return !of.gas || of.gas->pairs >= 1000;
}

/// Kept, since what they compile is.
SteppingEngine& engine_named(const Settings& settings, const std::string& name) {
  static std::map<std::string, std::unique_ptr<Engine>> engines;
  auto& engine = engines[name];
  if (!engine) engine = app::make_engine(name, {settings.data, "", settings.device});
  return dynamic_cast<SteppingEngine&>(*engine);
}

std::vector<Vec3> start_of(const Point& point) {
  return compared(point.scene, velocities_of(point.scene.make(1.0)));
}

/// Forces are evaluated once before the first step besides.
void report_point(benchmark::State& state, const Scene& scene, double error, double seconds) {
  for (auto _ : state) state.SetIterationTime(seconds);
  if (!(error < 1.0))
    throw EngineFailed("unstable: the error is as large as the motion, " + std::to_string(error));
  const auto steps = static_cast<double>(steps_of(scene));
  state.counters["step"] = scene.run.step;
  state.counters["steps"] = steps;
  state.counters["error"] = error;
  state.counters["wall_s"] = seconds;
  state.counters["force_evaluations"] = steps * evaluations_a_step(scene.run.integrator) + 1.0;
  state.counters["particles"] = static_cast<double>(scene.particles.size());
}

/// Error of what an engine or a peer came to, and what its exact solution is uncertain by.
void judge(benchmark::State& state, const Point& point, const Scene& scene, const Stepped& found,
           Variant variant, const std::vector<double>& restitutions) {
  const std::vector<Vec3> start = start_of(point), end = compared(point.scene, found.velocity);
  if (point.scene.gas && point.scene.gas->closed_form())
    return report_point(state, scene, scene_error(point.scene, end, rebounds(scene, restitutions), start),
                        found.seconds);
  const Exact& exact = fine_solution(point.scene, variant);
  state.counters["uncertainty"] = exact.uncertainty;
  report_point(state, scene, scene_error(point.scene, end, exact.velocity, start), found.seconds);
}

/// Two steps before, for what is compiled at the first time.
void measure_ours(benchmark::State& state, const Settings& settings, const Contestant& who,
                  const Point& point) {
  SteppingEngine& engine = engine_named(settings, who.engine);
  Scene scene = point.scene.make(point.steps_per_contact);
  scene.run.integrator = who.integrator;
  step_through(engine, scene, 2);
  std::vector<double> restitutions;
  if (point.scene.gas) restitutions.assign(scene.particles.size() / 2, point.scene.gas->restitution);
  judge(state, point, scene, step_through(engine, scene, steps_of(scene)), Variant::ours_and_lammps,
        restitutions);
}

std::string contacts_of(PeerProgram program, const AccuracyScene& of, const Scene& scene) {
  return of.gas ? pair_contacts(program, *of.gas, scene) : peer_contacts(program, scene);
}

/// The skin with which a peer is fastest at this point; a scene too small to be timed takes any.
double best_skin(const Settings& settings, PeerProgram program, const Point& point, Scene scene,
                 int processes) {
  static std::map<std::tuple<PeerProgram, std::string, double>, double> known;
  double& best = known[{program, point.scene.name, point.steps_per_contact}];
  if (best > 0.0) return best;
  best = 0.3 * diameter;
  if (scene.particles.size() < worth_timing || !is_timed(point.scene) || settings.quick) return best;
  double least = 1e300;
  for (const double skin : {0.1, 0.2, 0.4, 1.0}) {
    scene.run.skin = skin * diameter;
    const std::string contacts = contacts_of(program, point.scene, scene);
    const double seconds = run_peer(program, contacts, scene, steps_of(scene), processes).loop_s;
    if (seconds >= least) continue;
    least = seconds;
    best = scene.run.skin;
  }
  return best;
}

void measure_peer(benchmark::State& state, const Settings& settings, PeerProgram program,
                  const Point& point) {
  Scene scene = point.scene.make(point.steps_per_contact);
  const int processes = scene.particles.size() >= worth_timing ? thread_count(settings) : 1;
  if (!peer_is_here(program, processes)) throw EngineFailed("not installed");
  scene.run.skin = best_skin(settings, program, point, scene, processes);
  const PeerRun run =
      run_peer(program, contacts_of(program, point.scene, scene), scene, steps_of(scene), processes);
  state.counters["skin_m"] = scene.run.skin;
  std::vector<double> restitutions;
  if (point.scene.gas) restitutions = peer_restitutions(*point.scene.gas, scene);
  judge(state, point, scene, {run.velocity, run.loop_s},
        program == PeerProgram::lammps ? Variant::ours_and_lammps : Variant::liggghts, restitutions);
}

/// A point that fails is a row that says so.
void add_row(const std::string& name, const std::function<void(benchmark::State&)>& measure) {
  add_manual(name, [measure](benchmark::State& state) {
    try {
      measure(state);
    } catch (const std::exception& failure) {
      state.SkipWithError(failure.what());
    }
  });
}

std::string row_name(const AccuracyScene& scene, const std::string& key, Integrator integrator) {
  return "accuracy/scene:" + scene.name + "/" + key + "/integrator:" + std::string(name_of(integrator));
}

void add_unsupported(const AccuracyScene& scene, const std::string& key, Integrator integrator,
                     const std::string& because) {
  add_row(row_name(scene, key, integrator),
          [because](benchmark::State&) { throw InputRefused("unsupported: " + because); });
}

/// Whether its kernels are those of every gas of pairs that slide over nothing and stick to nothing.
bool is_plain(const AccuracyScene& of) {
  return of.gas && !of.gas->hertz && !of.gas->oblique && !of.gas->cohesive && !of.gas->drag;
}

/// Kernels are compiled for every scheme, precision and kind of scene, which takes longer than all that a
/// quick look measures: it compares the precisions where a program serves several scenes, and takes one
/// elsewhere.
std::vector<std::string> engines_in(const Settings& settings, const AccuracyScene& of) {
  std::vector<std::string> engines = settings.engines;
  if (!settings.quick || is_plain(of)) return engines;
  bool has_device = false;
  std::erase_if(engines, [&](const std::string& engine) {
    return engine.starts_with("opencl") && std::exchange(has_device, true);
  });
  return engines;
}

/// Those that can run the scene; the others get one row that says why not.
std::vector<Contestant> ours_in(const Settings& settings, const AccuracyScene& of) {
  std::vector<Contestant> able;
  Scene scene = of.make(of.steps_per_contact.front());
  for (const std::string& engine : engines_in(settings, of))
    for (const auto& [name, integrator] : integrator_names) {
      if (integrator == Integrator::euler_trapezoid_implicit_drag && !(of.gas && of.gas->drag))
        continue;  // without drag the same as explicit
      scene.run.integrator = integrator;
      const Support support = engine_named(settings, engine).supports(scene, {});
      if (support)
        able.push_back({engine_key(engine), engine, integrator});
      else
        add_unsupported(of, engine_key(engine), integrator, support.because);
    }
  return able;
}

struct Peer {
  PeerProgram program;
  std::string key;
};

std::vector<Peer> peers_in(const AccuracyScene& of) {
  std::vector<Peer> able;
  for (const Peer& peer : {Peer{PeerProgram::lammps, "engine:lammps/precision:double"},
                           Peer{PeerProgram::liggghts, "engine:liggghts/precision:double"}}) {
    const std::string lacks = of.gas ? peer_lacks(peer.program, *of.gas) : "";
    if (lacks.empty())
      able.push_back(peer);
    else
      add_unsupported(of, peer.key, Integrator::velocity_verlet, lacks);
  }
  return able;
}

/// All subjects of one point take turns.
void add_points(const Settings& settings, const AccuracyScene& scene) {
  const auto peers = peers_in(scene);
  const auto ours = ours_in(settings, scene);
  for (double ratio : scene.steps_per_contact)
    for (int round = 0; round < (is_timed(scene) ? settings.rounds : 1); ++round) {
      const std::string end =
          "/steps_per_contact:" + std::to_string(static_cast<int>(ratio)) + "/round:" + std::to_string(round);
      for (const Peer& peer : peers)
        add_row(row_name(scene, peer.key, Integrator::velocity_verlet) + end,
                [&settings, scene, ratio, peer](benchmark::State& state) {
                  measure_peer(state, settings, peer.program, {scene, ratio});
                });
      for (const Contestant& who : ours)
        add_row(row_name(scene, who.key, who.integrator) + end,
                [&settings, scene, ratio, who](benchmark::State& state) {
                  measure_ours(state, settings, who, {scene, ratio});
                });
    }
}

/// The table of errors once measured, beside what the peers that are here, and ours, make of it today.
void add_known_errors(const Settings& settings) {
  for (const KnownError& known : known_errors())
    for (const char* name : {"reference", "lammps", "liggghts"})
      add_row("accuracy/scene:known_" + std::string(name_of(known.quantity)) + "/engine:" + name +
                  "/precision:double/integrator:velocity_verlet/restitution:" +
                  std::to_string(known.restitution).substr(0, 3) +
                  "/steps_per_contact:" + std::to_string(static_cast<int>(known.steps_per_contact)),
              [&settings, known, name](benchmark::State& state) {
                const auto engine = app::make_engine(name, {settings.data, "", settings.device});
                const double error = error_now(*engine, known);
                for (auto _ : state) state.SetIterationTime(0.0);
                state.counters["error"] = error;
                state.counters["known_error"] = known.error;
              });
}

bool asked_for(const Settings& settings, const std::string& name) {
  return settings.scenes.empty() ||
         std::find(settings.scenes.begin(), settings.scenes.end(), name) != settings.scenes.end();
}

void add(const Settings& settings) {
  if (asked_for(settings, "known")) add_known_errors(settings);
  static const std::vector<AccuracyScene> scenes = accuracy_scenes(settings.quick, settings.cache);
  for (const AccuracyScene& scene : scenes)
    if (asked_for(settings, scene.name)) add_points(settings, scene);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
