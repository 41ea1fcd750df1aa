// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/settings.hpp"

#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "app/resources.hpp"

namespace grainproof::bench {
namespace {

void add_options(CLI::App& program, Settings& settings) {
  program.add_option("--cache", settings.cache);
  program.add_option("--device", settings.device);
  program.add_option("--threads", settings.threads);
  program.add_option("--rounds", settings.rounds);
  program.add_option("--seconds", settings.seconds);
  program.add_option("--scenes", settings.scenes)->delimiter(',');
  program.add_option("--engines", settings.engines)->delimiter(',');
  program.add_option("--particles", settings.particles)->delimiter(',');
  program.add_flag("--quick", settings.quick);
}

/// PoCL reads it when its first device is asked for.
void limit_threads(int threads) {
  if (threads > 0) setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(threads).c_str(), 1);
}

}  // namespace

int thread_count(const Settings& settings) {
  return settings.threads > 0 ? settings.threads : static_cast<int>(std::thread::hardware_concurrency());
}

int run_benchmarks(int argc, char** argv, void (*add)(const Settings&)) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // each line when it is ready, also into a pipe
  benchmark::Initialize(&argc, argv);
  Settings settings;
  CLI::App program("One suite of ./grainproof bench; takes Google Benchmark's options too");
  add_options(program, settings);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error);
  }
  limit_threads(settings.threads);
  try {
    settings.data = app::data_root();
    if (settings.cache.empty()) settings.cache = std::filesystem::temp_directory_path() / "grainproof-cache";
    add(settings);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& failure) {
    std::cerr << failure.what() << std::endl;
    return 1;
  }
  return 0;
}

}  // namespace grainproof::bench
