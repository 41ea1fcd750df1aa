// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"

namespace grainproof::bench {
namespace {

void add_scene(const Settings& settings, const std::string& scene, std::int64_t particles) {
  std::vector<std::pair<std::string, std::shared_ptr<Subject>>> subjects;
  for (const std::string& engine : settings.engines)
    subjects.emplace_back(engine_key(engine), std::make_shared<Subject>(
                                                  engine,
                                                  [&settings, scene](std::int64_t size) {
                                                    return scene_named(scene, size, settings.cache);
                                                  },
                                                  particles, settings));
  for (int round = 0; round < settings.rounds; ++round)
    for (const auto& [key, subject] : subjects)
      add_measurement("cundall/scene:" + sized_name(scene, particles) + "/" + key + "/threads:" +
                          std::to_string(thread_count(settings)) + "/round:" + std::to_string(round),
                      subject);
}

void add(const Settings& settings) {
  for (const std::string& scene : settings.scenes)
    for (const std::int64_t particles : settings.particles) add_scene(settings, scene, particles);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
