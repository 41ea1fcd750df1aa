// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"

namespace grainproof::bench {
namespace {

/// One size at a time is in memory, so a program measures one.
void add(const Settings& settings) {
  for (const std::string& scene : settings.scenes)
    for (const std::string& engine : settings.engines) {
      const std::int64_t particles = settings.particles.at(0);
      const auto subject = std::make_shared<Subject>(
          engine, [&settings, scene](std::int64_t size) { return scene_named(scene, size, settings.cache); },
          particles, settings);
      for (int round = 0; round < settings.rounds; ++round)
        add_measurement("scaling/scene:" + scene + "/" + engine_key(engine) +
                            "/threads:" + std::to_string(thread_count(settings)) +
                            "/size:" + std::to_string(particles) + "/round:" + std::to_string(round),
                        subject);
    }
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
