// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <chrono>

#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"
#include "reference_cpu/neighbours/all_pairs.hpp"
#include "reference_cpu/neighbours/chain_cells.hpp"

namespace grainproof::bench {
namespace {

constexpr double usual_skin = 0.3 * diameter;
constexpr std::int64_t most_for_all_pairs = 20000;                 // beyond, a step takes seconds
constexpr std::array skins{0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4};  // diameters

std::string of_round(int round) {
  return "/round:" + std::to_string(round);
}

/// One search of every close pair, as a rebuild of the reference's list does it.
class Search {
 public:
  explicit Search(const Scene& scene, bool cells)
      : bodies_(reference::bodies_of(scene)), box_(scene.domain), cells_(cells) {}

  double seconds() {
    const auto began = std::chrono::steady_clock::now();
    if (cells_) {
      chains_.fill(reference::grid_over(bodies_, box_, diameter + usual_skin), bodies_);
      chains_.list_pairs(bodies_, box_, usual_skin, list_);
    } else {
      reference::list_all_pairs(bodies_, box_, usual_skin, list_);
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }

 private:
  reference::Bodies bodies_;
  reference::PeriodicBox box_;
  bool cells_;
  reference::ChainCells chains_;
  reference::PairList list_;
};

void add_update(const Settings& settings, std::int64_t particles, bool cells) {
  for (int round = 0; round < settings.rounds; ++round)
    add_manual(std::string("neighbours/what:update/engine:reference/precision:double/way:") +
                   (cells ? "chain cells" : "all pairs") + "/size:" + std::to_string(particles) +
                   of_round(round),
               [=](benchmark::State& state) {
                 Search search(gas(particles), cells);
                 search.seconds();
                 double spent = 0.0;
                 for (auto _ : state) state.SetIterationTime(spent = search.seconds());
                 state.counters["particles"] = static_cast<double>(particles);
                 state.counters["update_s"] = spent;
               });
}

/// Whole steps of a gas, lists included.
void add_steps(const Settings& settings, std::int64_t particles, const std::string& engine,
               const std::string& way, NeighbourSearch search, double skin) {
  const auto make = [=](std::int64_t size) {
    Scene scene = gas(size);
    scene.run.neighbours = search;
    scene.run.skin = skin;
    return scene;
  };
  const auto subject = std::make_shared<Subject>(engine, make, particles, settings);
  for (int round = 0; round < settings.rounds; ++round)
    add_measurement("neighbours/what:step/" + engine_key(engine) + "/way:" + way +
                        "/size:" + std::to_string(particles) + of_round(round),
                    subject);
}

/// The list of an engine whose searches can't be called alone: a new one every step, less steps without one.
void add_list_each_step(const Settings& settings, std::int64_t particles, const std::string& engine) {
  add_steps(settings, particles, engine, "list every step", NeighbourSearch::automatic, 0.0);
  const auto still = [](std::int64_t size) {
    Scene scene = gas(size);
    scene.run.skin = 0.0;
    for (Particle& particle : scene.particles) particle.velocity = Vec3::Zero();
    return scene;
  };
  const auto subject = std::make_shared<Subject>(engine, still, particles, settings);
  for (int round = 0; round < settings.rounds; ++round)
    add_measurement("neighbours/what:step/" + engine_key(engine) +
                        "/way:no list at all/size:" + std::to_string(particles) + of_round(round),
                    subject);
}

void add_skins(const Settings& settings, const std::string& scene, const std::string& engine,
               std::int64_t particles) {
  std::vector<std::pair<double, std::shared_ptr<Subject>>> subjects;
  for (double skin : skins) {
    const auto make = [&settings, scene, skin](std::int64_t size) {
      Scene made = scene_named(scene, size, settings.cache);
      made.run.skin = skin * diameter;
      return made;
    };
    subjects.emplace_back(skin, std::make_shared<Subject>(engine, make, particles, settings));
  }
  for (int round = 0; round < settings.rounds; ++round)
    for (const auto& [skin, subject] : subjects)
      add_measurement("neighbours/what:skin/scene:" + sized_name(scene, particles) + "/" +
                          engine_key(engine) + "/skin:" + std::to_string(skin) + of_round(round),
                      subject);
}

void add_size(const Settings& settings, std::int64_t particles) {
  add_update(settings, particles, true);
  if (particles <= most_for_all_pairs) add_update(settings, particles, false);
  for (const std::string& engine : settings.engines) {
    if (engine != "reference") {
      add_steps(settings, particles, engine, "list", NeighbourSearch::automatic, usual_skin);
      add_list_each_step(settings, particles, engine);
      continue;
    }
    add_steps(settings, particles, engine, "chain cells and list", NeighbourSearch::verlet_list, usual_skin);
    add_steps(settings, particles, engine, "chain cells", NeighbourSearch::cells, -1.0);
    if (particles <= most_for_all_pairs)
      add_steps(settings, particles, engine, "all pairs", NeighbourSearch::all_pairs, -1.0);
  }
}

void add(const Settings& settings) {
  for (std::int64_t particles : settings.particles) add_size(settings, particles);
  for (const std::string& scene : settings.scenes)
    for (const std::string& engine : settings.engines)
      add_skins(settings, scene, engine, settings.particles.back());
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
