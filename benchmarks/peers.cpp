// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <iostream>
#include <limits>
#include <map>

#include "benchmarks/common/peer_subject.hpp"
#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"

namespace grainproof::bench {
namespace {

constexpr std::array skins{0.02, 0.05, 0.1, 0.2, 0.3, 0.4};  // diameters
constexpr std::array few_skins{0.1, 0.3};
constexpr int turns_of_skins = 4;
constexpr double within_noise = 1.05;  // the smaller of two skins that are as fast as can be told

/// What competes on one scene: a row's key, and how it is measured.
struct Competitor {
  std::string key;
  std::function<void(benchmark::State&)> measure;
};

/// The skin, in metres, with which `step_seconds` is least, as far as can be told. All are tried in turns,
/// since a machine that slows down for a while would choose among them otherwise.
template <class StepSeconds>
double best_skin(const Settings& settings, const std::string& who, StepSeconds step_seconds) {
  const auto tried = settings.quick ? std::span<const double>(few_skins) : std::span<const double>(skins);
  std::vector<double> least(tried.size(), std::numeric_limits<double>::max());
  for (int turn = 0; turn < (settings.quick ? 1 : turns_of_skins); ++turn)
    for (std::size_t i = 0; i < tried.size(); ++i)
      least[i] = std::min(least[i], step_seconds(tried[i] * diameter));
  const double enough = within_noise * *std::ranges::min_element(least);
  const auto first = std::ranges::find_if(least, [&](double seconds) { return seconds <= enough; });
  const double best = tried[static_cast<std::size_t>(first - least.begin())];
  std::cout << "note: best skin of " << who << ": " << best << " diameters" << std::endl;
  return best * diameter;
}

/// Lists are alike at every size, so the skin is chosen where it costs little.
std::int64_t size_for_skins(std::int64_t particles) {
  return std::min(particles, tile_particles);
}

Competitor peer(const Settings& settings, PeerProgram program, const std::string& name,
                const std::string& scene, std::int64_t particles) {
  std::shared_ptr<PeerSubject> subject;
  const auto measure = [=, &settings](benchmark::State& state) mutable {
    const int processes = thread_count(settings);
    if (!peer_is_here(program, processes)) return state.SkipWithError("not installed");
    if (!subject) {
      constexpr std::int64_t steps = 300;
      PeerSubject trial(program, scene_named(scene, size_for_skins(particles), settings.cache), processes,
                        0.0);
      const double skin =
          best_skin(settings, name, [&](double tried) { return trial.step_seconds(tried, steps); });
      subject = std::make_shared<PeerSubject>(program, scene_named(scene, particles, settings.cache),
                                              processes, settings.seconds);
      subject->use_skin(skin);
    }
    subject->measure(state);
  };
  return {"engine:" + name + "/precision:double", measure};
}

std::shared_ptr<Subject> with_skin(const Settings& settings, const std::string& engine,
                                   const std::string& scene, std::int64_t particles, double skin) {
  const auto make = [&settings, scene, skin](std::int64_t size) {
    Scene made = scene_named(scene, size, settings.cache);
    made.run.skin = skin;
    return made;
  };
  return std::make_shared<Subject>(engine, make, particles, settings);
}

Competitor ours(const Settings& settings, const std::string& engine, const std::string& scene,
                std::int64_t particles) {
  std::shared_ptr<Subject> subject;
  const auto measure = [=, &settings](benchmark::State& state) mutable {
    if (!subject) {
      Settings brief = settings;
      brief.seconds /= turns_of_skins;
      std::map<double, std::shared_ptr<Subject>> trials;
      const double skin = best_skin(settings, engine, [&](double tried) {
        auto& trial = trials[tried];
        if (!trial) trial = with_skin(brief, engine, scene, size_for_skins(particles), tried);
        return trial->step_seconds();
      });
      subject = with_skin(settings, engine, scene, particles, skin);
    }
    subject->measure(state);
  };
  return {engine_key(engine), measure};
}

void add_scene(const Settings& settings, const std::string& scene, std::int64_t particles) {
  std::vector<Competitor> competitors{peer(settings, PeerProgram::lammps, "lammps", scene, particles),
                                      peer(settings, PeerProgram::liggghts, "liggghts", scene, particles)};
  for (const std::string& engine : settings.engines)
    competitors.push_back(ours(settings, engine, scene, particles));
  for (Competitor& one : competitors) {
    const auto shared = std::make_shared<std::function<void(benchmark::State&)>>(std::move(one.measure));
    one.measure = [shared](benchmark::State& state) { (*shared)(state); };
  }
  for (int round = 0; round < settings.rounds; ++round)
    for (const Competitor& one : competitors)
      add_manual("peers/scene:" + sized_name(scene, particles) + "/" + one.key + "/processes:" +
                     std::to_string(thread_count(settings)) + "/round:" + std::to_string(round),
                 one.measure);
}

void add(const Settings& settings) {
  for (const std::string& scene : settings.scenes)
    for (std::int64_t particles : settings.particles) add_scene(settings, scene, particles);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
