// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <map>

#include "app/engines.hpp"
#include "benchmarks/common/pair_gas.hpp"
#include "benchmarks/common/pair_peer.hpp"
#include "benchmarks/common/peer_subject.hpp"
#include "benchmarks/common/subject.hpp"
#include "model/errors.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int finer = 64;  ///< of the step of a reference solution, where there is no closed form

std::vector<double> steps_per_contact(const Settings& settings) {
  return settings.quick ? std::vector<double>{8, 32, 128} : std::vector<double>{8, 16, 32, 64, 128, 256, 512};
}

std::vector<Vec3> start_of(const Scene& scene) {
  std::vector<Vec3> velocity;
  for (const Particle& particle : scene.particles) velocity.push_back(particle.velocity);
  return relative_velocities(velocity);
}

struct Stepped {
  std::vector<Vec3> velocity;
  double seconds = 0.0;
};

Stepped step_through(SteppingEngine& engine, const Scene& scene, std::int64_t steps) {
  const auto run = engine.start(scene, {});
  const auto began = Clock::now();
  run->advance(steps);
  run->synchronise();
  const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
  return {run->frame().velocity, seconds};
}

/// Of the variant that `like` has, so that a peer is held against its own law.
std::vector<Vec3> fine_solution(const PairGas& gas, double ratio, const HistoryFriction& like) {
  static std::map<std::pair<double, CoulombLimit>, std::vector<Vec3>> known;
  std::vector<Vec3>& solution = known[{ratio, like.limit}];
  if (!solution.empty()) return solution;
  Scene scene = pair_scene(gas, ratio);
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = like;
  scene.contacts.set(0, 0, laws);
  scene.run.step /= finer;
  reference::ReferenceEngine engine;
  return solution =
             relative_velocities(step_through(engine, scene, finer * steps_to_part(scene, ratio)).velocity);
}

HistoryFriction friction_of(const Scene& scene) {
  return std::get<HistoryFriction>(scene.contacts.at(0, 0).friction);
}

HistoryFriction as_liggghts(HistoryFriction law) {
  law.limit = CoulombLimit::spring;
  law.arm = TorqueArm::overlap;
  return law;
}

void report_point(benchmark::State& state, const Scene& scene, std::int64_t steps, double error,
                  double seconds) {
  for (auto _ : state) state.SetIterationTime(seconds);
  state.counters["step"] = scene.run.step;
  state.counters["error"] = error;
  state.counters["wall_s"] = seconds;
  state.counters["force_evaluations"] = static_cast<double>(steps) + 1.0;
  state.counters["particles"] = static_cast<double>(scene.particles.size());
}

/// Once before, for what is compiled at the first time.
void measure_ours(benchmark::State& state, const Settings& settings, const std::string& name,
                  const PairGas& gas, Integrator integrator, double ratio) {
  const auto made = app::make_engine(name, {settings.data, "", settings.device});
  auto& engine = dynamic_cast<SteppingEngine&>(*made);
  Scene scene = pair_scene(gas, ratio);
  scene.run.integrator = integrator;
  if (const Support support = engine.supports(scene, {}); !support)
    throw InputRefused("unsupported: " + support.because);
  step_through(engine, scene, 2);
  const std::int64_t steps = steps_to_part(scene, ratio);
  const Stepped stepped = step_through(engine, scene, steps);
  const std::vector<Vec3> exact =
      gas.oblique ? fine_solution(gas, ratio, friction_of(scene))
                  : rebounds(scene, std::vector<double>(scene.particles.size() / 2, gas.restitution));
  report_point(state, scene, steps, rms_error(relative_velocities(stepped.velocity), exact, start_of(scene)),
               stepped.seconds);
}

void measure_peer(benchmark::State& state, const Settings& settings, PeerProgram program, const PairGas& gas,
                  double ratio) {
  const int processes = gas.pairs >= 1000 ? thread_count(settings) : 1;
  if (!peer_is_here(program, processes)) throw EngineFailed("not installed");
  if (const std::string lacks = peer_lacks(program, gas); !lacks.empty())
    throw InputRefused("unsupported: " + lacks);
  const Scene scene = pair_scene(gas, ratio);
  const std::int64_t steps = steps_to_part(scene, ratio);
  const PeerPoint point = run_peer(program, gas, scene, steps, processes);
  std::vector<Vec3> exact;
  if (gas.oblique)
    exact = fine_solution(
        gas, ratio, program == PeerProgram::lammps ? friction_of(scene) : as_liggghts(friction_of(scene)));
  else
    exact = rebounds(scene, point.restitution);
  report_point(state, scene, steps, rms_error(relative_velocities(point.velocity), exact, start_of(scene)),
               point.loop_s);
}

/// A point that fails is a row that says so.
template <class Measure>
void add_point(const Settings& settings, const PairGas& gas, const std::string& who, Integrator integrator,
               double ratio, Measure measure) {
  for (int round = 0; round < settings.rounds; ++round)
    add_manual("accuracy/scene:" + gas.name + "/" + who + "/integrator:" + std::string(name_of(integrator)) +
                   "/steps_per_contact:" + std::to_string(static_cast<int>(ratio)) +
                   "/round:" + std::to_string(round),
               [measure](benchmark::State& state) {
                 try {
                   measure(state);
                 } catch (const std::exception& failure) {
                   state.SkipWithError(failure.what());
                 }
               });
}

void add_points(const Settings& settings, const PairGas& gas, double ratio) {
  for (const auto& [name, program] :
       {std::pair{"lammps", PeerProgram::lammps}, {"liggghts", PeerProgram::liggghts}})
    add_point(settings, gas, std::string("engine:") + name + "/precision:double", Integrator::velocity_verlet,
              ratio, [&settings, gas, ratio, program = program](benchmark::State& state) {
                measure_peer(state, settings, program, gas, ratio);
              });
  for (const std::string& engine : settings.engines)
    for (const auto& [name, integrator] : integrator_names) {
      if (integrator == Integrator::euler_trapezoid_implicit_drag)
        continue;  // without drag the same as explicit
      add_point(settings, gas, engine_key(engine), integrator, ratio,
                [&settings, gas, ratio, engine, integrator = integrator](benchmark::State& state) {
                  measure_ours(state, settings, engine, gas, integrator, ratio);
                });
    }
}

void add(const Settings& settings) {
  for (const PairGas& gas : pair_gases(settings.quick))
    for (double ratio : steps_per_contact(settings)) add_points(settings, gas, ratio);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
