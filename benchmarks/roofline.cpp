// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/device.hpp"
#include "benchmarks/common/subject.hpp"

namespace grainproof::bench {
namespace {

constexpr std::size_t vector_bytes = 64;
constexpr std::size_t group = 64;
constexpr double flops_a_round = 10.0 * 16.0 * 2.0;

/// Far more than the caches hold, unless the user is in a hurry.
std::size_t copied_bytes(const Settings& settings) {
  return settings.quick ? std::size_t{1} << 28 : std::size_t{1} << 30;
}

double copy_rate(const Settings& settings) {
  Device device(settings, "roofline.cl");
  const std::size_t bytes = copied_bytes(settings), items = bytes / vector_bytes;
  const cl::Buffer from = device.room(bytes), to = device.room(bytes);
  cl::Kernel kernel = device.kernel("copy");
  kernel.setArg(0, from);
  kernel.setArg(1, to);
  constexpr int times = 3;
  return 2.0 * static_cast<double>(bytes) * times / device.seconds(kernel, items, group, times);
}

double multiply_add_rate(const Settings& settings) {
  Device device(settings, "roofline.cl");
  const std::size_t items = 1 << 18;
  constexpr cl_int rounds = 256;
  const cl::Buffer out = device.room(items * vector_bytes);
  cl::Kernel kernel = device.kernel("multiply_add");
  kernel.setArg(0, out);
  kernel.setArg(1, 1.0F);
  kernel.setArg(2, rounds);
  return flops_a_round * rounds * static_cast<double>(items) / device.seconds(kernel, items, group);
}

void add_rate(const Settings& settings, const std::string& what, double (*rate)(const Settings&)) {
  for (int round = 0; round < settings.rounds; ++round)
    add_manual("roofline/what:" + what + "/threads:" + std::to_string(thread_count(settings)) +
                   "/round:" + std::to_string(round),
               [&settings, rate](benchmark::State& state) {
                 for (auto _ : state) state.SetIterationTime(1.0);
                 state.counters["rate"] = rate(settings);
               });
}

void add(const Settings& settings) {
  add_rate(settings, "copy, bytes a second", copy_rate);
  add_rate(settings, "multiply-add, flops a second", multiply_add_rate);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
