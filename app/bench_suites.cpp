// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_suites.hpp"

#include <algorithm>
#include <array>
#include <thread>

#include "app/bench_long.hpp"

namespace grainproof::app {
namespace {

/// The reference is serial.
std::vector<std::string> on_threads(std::vector<std::string> engines, const BenchSession& session,
                                    int threads) {
  if (threads > 1 && thread_counts(session).size() > 1) std::erase(engines, "reference");
  return engines;
}

void measure_cundall(BenchSession& session) {
  const std::vector<std::int64_t> sizes =
      session.quick() ? std::vector<std::int64_t>{10000} : std::vector<std::int64_t>{10000, 100000, 1000000};
  for (int threads : thread_counts(session))
    session.run({.suite = "cundall",
                 .what = std::to_string(threads) + " threads",
                 .scenes = {"bed", "gas"},
                 .engines = on_threads(session.engines_in_every_precision(), session, threads),
                 .particles = within_limits(session, sizes),
                 .threads = threads,
                 .rounds = session.quick() ? 2 : 5,
                 .seconds = session.quick() ? 0.2 : 1.0});
}

void measure_neighbours(BenchSession& session) {
  const std::vector<std::int64_t> sizes =
      session.quick()
          ? std::vector<std::int64_t>{1000, 2000, 4000, 10000}
          : std::vector<std::int64_t>{1000, 2000, 4000, 10000, 15000, 20000, 25000, 30000, 35000, 40000};
  const std::vector<Sample> found = session.run({.suite = "neighbours",
                                                 .what = "searches and skins",
                                                 .scenes = {"bed", "gas"},
                                                 .engines = session.engines(),
                                                 .particles = within_limits(session, sizes),
                                                 .rounds = session.quick() ? 1 : 3,
                                                 .seconds = session.quick() ? 0.05 : 0.5});
  conclude_neighbours(session, found);
}

void measure_features(BenchSession& session) {
  const std::int64_t size = session.quick() ? 10000 : 100000;
  std::vector<std::string> engines = session.engines();
  if (session.quick() && engines.size() > 2) engines.resize(2);  // many kernels are compiled
  conclude_features(session, session.run({.suite = "features",
                                          .what = "each on and off",
                                          .engines = engines,
                                          .particles = within_limits(session, {size}),
                                          .rounds = session.quick() ? 2 : 7,
                                          .seconds = session.quick() ? 0.05 : 0.5}));
}

void measure_layout(BenchSession& session) {
  const std::int64_t size = session.quick() ? 10000 : 1000000;
  session.run({.suite = "layout",
               .what = "questions of memory and parallel shape",
               .particles = within_limits(session, {size}),
               .rounds = session.quick() ? 2 : 5});
}

/// One program a scene, so that a large one has the memory to itself.
void measure_peers(BenchSession& session) {
  struct Scenes {
    const char* name;
    std::vector<std::int64_t> sizes;
  };
  const std::vector<Scenes> scenes =
      session.quick() ? std::vector<Scenes>{{"bed", {10000}}, {"gas", {10000}}}
                      : std::vector<Scenes>{{"bed", {10000, 100000, 1000000}}, {"gas", {10000, 100000}}};
  for (const Scenes& scene : scenes)
    for (std::int64_t size : within_limits(session, scene.sizes))
      for (int threads : thread_counts(session))
        conclude_peers(session, session.run({.suite = "peers",
                                             .what = std::string(scene.name) + " of " + std::to_string(size) +
                                                     ", " + std::to_string(threads) + " processes",
                                             .scenes = {scene.name},
                                             .engines = on_threads(session.engines(), session, threads),
                                             .particles = {size},
                                             .threads = threads,
                                             .rounds = session.quick() ? 2 : 5,
                                             .seconds = session.quick() ? 0.3 : 3.0}));
}

void measure_accuracy(BenchSession& session) {
  session.run({.suite = "accuracy",
               .what = "collisions, error and time",
               .engines = session.engines_in_every_precision(),
               .rounds = session.quick() ? 1 : 3});
  conclude_accuracy(session);
}

constexpr std::array scaling_columns{
    ShownColumn{"scene", "scene"},
    ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"},
    ShownColumn{"particles", "particles"},
    ShownColumn{"step_s", "s a step"},
    ShownColumn{"cundall_number", "C"},
    ShownColumn{"bytes_per_particle", "B/particle"},
    ShownColumn{"bandwidth_share", "of copy rate"},
    ShownColumn{"flops_share", "of FMA rate"},
    ShownColumn{"status", "status"},
};

constexpr std::array cundall_columns{
    ShownColumn{"scene", "scene"},
    ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"},
    ShownColumn{"threads", "threads"},
    ShownColumn{"cundall_number", "C"},
    ShownColumn{"cundall_min", "least"},
    ShownColumn{"cundall_max", "most"},
    ShownColumn{"bytes_per_particle", "B/particle"},
    ShownColumn{"bandwidth_share", "of copy rate"},
    ShownColumn{"flops_share", "of FMA rate"},
    ShownColumn{"rebuilds", "rebuilds"},
    ShownColumn{"status", "status"},
};

constexpr std::array neighbours_columns{
    ShownColumn{"what", "what"},
    ShownColumn{"scene", "scene"},
    ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"},
    ShownColumn{"way", "way"},
    ShownColumn{"skin", "skin / d"},
    ShownColumn{"particles", "particles"},
    ShownColumn{"update_s", "s an update"},
    ShownColumn{"step_s", "s a step"},
    ShownColumn{"status", "status"},
};

constexpr std::array features_columns{
    ShownColumn{"scene", "scene"},         ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"}, ShownColumn{"feature", "feature"},
    ShownColumn{"with", "with"},           ShownColumn{"step_s", "s a step"},
    ShownColumn{"cundall_number", "C"},    ShownColumn{"status", "status"},
};

constexpr std::array costs_columns{
    ShownColumn{"scene", "scene"},         ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"}, ShownColumn{"cost", "cost of"},
    ShownColumn{"with", "with"},           ShownColumn{"steps", "steps a piece"},
    ShownColumn{"step_s", "s a step"},     ShownColumn{"cpu_step_s", "processor s"},
    ShownColumn{"cundall_number", "C"},    ShownColumn{"bytes_per_particle", "B/particle"},
    ShownColumn{"status", "status"},
};

constexpr std::array layout_columns{
    ShownColumn{"what", "what"},           ShownColumn{"way", "way"},
    ShownColumn{"particles", "particles"}, ShownColumn{"ns_a_particle", "ns a particle"},
    ShownColumn{"status", "status"},
};

constexpr std::array peers_columns{
    ShownColumn{"scene", "scene"},
    ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"},
    ShownColumn{"processes", "processes"},
    ShownColumn{"skin_m", "skin / m"},
    ShownColumn{"cundall_number", "C"},
    ShownColumn{"cundall_min", "least"},
    ShownColumn{"cundall_max", "most"},
    ShownColumn{"bytes_per_particle", "B/particle"},
    ShownColumn{"status", "status"},
};

constexpr std::array accuracy_columns{
    ShownColumn{"scene", "scene"},
    ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"},
    ShownColumn{"integrator", "integrator"},
    ShownColumn{"steps_per_contact", "steps a contact"},
    ShownColumn{"error", "error"},
    ShownColumn{"order", "order"},
    ShownColumn{"wall_s", "s"},
    ShownColumn{"status", "status"},
};

constexpr std::array stability_columns{
    ShownColumn{"scene", "scene"},
    ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"},
    ShownColumn{"integrator", "integrator"},
    ShownColumn{"restitution", "restitution"},
    ShownColumn{"mass_ratio", "masses"},
    ShownColumn{"stiffness_ratio", "stiffnesses"},
    ShownColumn{"coordination", "contacts"},
    ShownColumn{"friction", "friction"},
    ShownColumn{"limit_s", "limit / s"},
    ShownColumn{"predicted_s", "predicted"},
    ShownColumn{"share_of_contact", "of a contact"},
    ShownColumn{"error", "apart"},
    ShownColumn{"step", "step / s"},
    ShownColumn{"end", "after / s"},
    ShownColumn{"overlap_error", "overlap off by"},
    ShownColumn{"status", "status"},
};

constexpr std::array long_columns{
    ShownColumn{"scene", "scene"},         ShownColumn{"engine", "engine"},
    ShownColumn{"precision", "precision"}, ShownColumn{"integrator", "integrator"},
    ShownColumn{"quantity", "drift of"},   ShownColumn{"steps", "steps"},
    ShownColumn{"measured", "measured"},   ShownColumn{"bound", "bound"},
    ShownColumn{"verdict", "verdict"},     ShownColumn{"because", "because"},
    ShownColumn{"status", "status"},
};

constexpr std::array suites{
    Suite{"scaling", "run time against the number of particles, with the exponent", measure_scaling,
          scaling_columns},
    Suite{"cundall", "particles times steps a second, by engine, precision and threads", measure_cundall,
          cundall_columns},
    Suite{"neighbours", "searches, their growth and share, and the best skin", measure_neighbours,
          neighbours_columns},
    Suite{"features", "what each feature costs, on against off", measure_features, features_columns},
    Suite{"costs", "what may cost only so much: upper bounds of 95 % against their bars", measure_costs,
          costs_columns},
    Suite{"layout", "records or arrays, scans, sums of forces, sizes of zones", measure_layout,
          layout_columns},
    Suite{"peers", "against LAMMPS and LIGGGHTS on the same scenes, interleaved", measure_peers,
          peers_columns},
    Suite{"accuracy", "error against run time, by integrator, engine, precision and peer", measure_accuracy,
          accuracy_columns},
    Suite{"stability", "largest stable steps against their prediction", measure_stability, stability_columns},
    Suite{"long", "what drifts in a million bounces and ten million steps", measure_long, long_columns},
};

}  // namespace

std::span<const Suite> bench_suites() {
  return suites;
}

std::vector<int> thread_counts(const BenchSession& session) {
  const int all = static_cast<int>(std::thread::hardware_concurrency());
  if (all == 1 || !session.on_processor()) return {all};
  return {1, all};
}

std::vector<std::int64_t> within_limits(const BenchSession& session, std::vector<std::int64_t> sizes) {
  const std::int64_t least = session.options().least, most = session.options().most;
  std::erase_if(sizes, [&](std::int64_t size) { return size < least || (most > 0 && size > most); });
  if (sizes.empty()) sizes.push_back(most > 0 ? most : least);
  return sizes;
}

}  // namespace grainproof::app
