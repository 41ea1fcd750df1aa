// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/peer_subject.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

constexpr std::int64_t warm_up = 20;
constexpr std::int64_t trial_steps = 50;
constexpr std::int64_t most_steps = 1000000;

const char* program_name(PeerProgram program) {
  return program == PeerProgram::lammps ? "lmp" : "liggghts";
}

/// What the program says of its last run.
struct Told {
  double loop_s = 0.0;
  double megabytes_a_process = 0.0;
};

Told read_output(const std::filesystem::path& file) {
  std::ifstream in(file);
  Told told;
  for (std::string line; std::getline(in, line);) {
    sscanf(line.c_str(), "Loop time of %lf", &told.loop_s);
    sscanf(line.c_str(), "Memory usage per processor = %lf", &told.megabytes_a_process);
    sscanf(line.c_str(), "Per MPI rank memory allocation (min/avg/max) = %*f | %lf",
           &told.megabytes_a_process);
  }
  return told;
}

}  // namespace

bool peer_is_here(PeerProgram program, int processes) {
  return find_program(program_name(program)) && (processes == 1 || find_program("mpirun"));
}

PeerSubject::PeerSubject(PeerProgram program, Scene scene, int processes, double seconds)
    : scene_(std::move(scene)), program_(program), processes_(processes), seconds_(seconds) {
  write_peer_data(scene_, folder_.path() / "data");
}

double PeerSubject::step_seconds(double skin, std::int64_t steps) {
  std::ofstream(folder_.path() / "deck") << peer_deck(program_, scene_, skin, warm_up, steps);
  std::vector<std::string> words;
  if (processes_ > 1)
    words = {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", std::to_string(processes_)};
  for (const char* word : {program_name(program_), "-in", "deck", "-log", "none"}) words.emplace_back(word);
  const std::filesystem::path output = folder_.path() / "output";
  const int status = run_program(words, folder_.path(), output);
  const Told told = read_output(output);
  if (status != 0 || told.loop_s <= 0.0)
    throw EngineFailed(std::string(program_name(program_)) + " ended with status " + std::to_string(status) +
                       ": " + last_lines(output, 3));
  bytes_ = told.megabytes_a_process * 1048576.0 * processes_;
  return told.loop_s / static_cast<double>(steps);
}

void PeerSubject::measure(benchmark::State& state) {
  const auto particles = static_cast<double>(scene_.particles.size());
  try {
    if (steps_ == 0)
      steps_ = std::clamp(static_cast<std::int64_t>(seconds_ / step_seconds(skin_, trial_steps)), trial_steps,
                          most_steps);
    double step_s = 0.0;
    for (auto _ : state) {
      step_s = step_seconds(skin_, steps_);
      state.SetIterationTime(step_s * static_cast<double>(steps_));
    }
    state.counters["particles"] = particles;
    state.counters["steps"] = static_cast<double>(steps_);
    state.counters["step_s"] = step_s;
    state.counters["cundall_number"] = particles / step_s;
    state.counters["bytes_per_particle"] = bytes_ / particles;
    state.counters["skin_m"] = skin_;
  } catch (const std::exception& failure) {
    state.SkipWithError(failure.what());
  }
}

}  // namespace grainproof::bench
