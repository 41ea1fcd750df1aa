// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>

#include "benchmarks/common/device.hpp"
#include "benchmarks/common/layout_data.hpp"
#include "benchmarks/common/subject.hpp"

namespace grainproof::bench {
namespace {

constexpr std::size_t group = 64;
constexpr int times = 10;  // launches a measurement
constexpr cl_float step = 1e-6F;

using Measure = double (*)(const Settings&, const LayoutData&);

template <class T>
cl::Buffer filled(Device& device, const std::vector<T>& values) {
  cl::Buffer buffer = device.room(sizeof(T) * values.size());
  device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, sizeof(T) * values.size(), values.data());
  return buffer;
}

template <class... Arguments>
cl::Kernel with(Device& device, const char* name, const Arguments&... arguments) {
  cl::Kernel kernel = device.kernel(name);
  cl_uint index = 0;
  (kernel.setArg(index++, arguments), ...);
  return kernel;
}

cl::Buffer records(Device& device, const LayoutData& data) {
  struct Record {
    cl_float4 position, rest[7];
  };
  std::vector<Record> all(data.positions.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i].position = data.positions[i];
  return filled(device, all);
}

double move_records(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/records.cl");
  const cl::Buffer all = records(device, data);
  return device.seconds(with(device, "move_records", all, step), data.positions.size(), group, times);
}

double move_arrays(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/records.cl");
  const std::vector<cl_float4> zeros(data.positions.size(), cl_float4{});
  const cl::Buffer position = filled(device, data.positions), velocity = filled(device, zeros),
                   force = filled(device, zeros);
  return device.seconds(with(device, "move_arrays", position, velocity, force, step), data.positions.size(),
                        group, times);
}

double gather_records(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/records.cl");
  const cl::Buffer all = records(device, data), starts = filled(device, data.starts),
                   partners = filled(device, data.partners);
  return device.seconds(with(device, "gather_records", all, starts, partners), data.positions.size(), group,
                        times);
}

double gather_arrays(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/records.cl");
  const cl::Buffer position = filled(device, data.positions),
                   forces = device.room(sizeof(cl_float4) * data.positions.size()),
                   starts = filled(device, data.starts), partners = filled(device, data.partners);
  return device.seconds(with(device, "gather_arrays", position, forces, starts, partners),
                        data.positions.size(), group, times);
}

std::size_t padded(std::size_t count) {
  return (count + group - 1) / group * group;
}

double compare_and_swap(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/accumulate.cl");
  const std::vector<cl_float4> zeros(data.positions.size(), cl_float4{});
  const cl::Buffer position = filled(device, data.positions), pairs = filled(device, data.pairs),
                   forces = filled(device, zeros);
  const auto count = static_cast<cl_int>(data.pairs.size());
  return device.seconds(with(device, "compare_and_swap", position, pairs, count, forces),
                        padded(data.pairs.size()), group, times);
}

double write_and_gather(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/accumulate.cl");
  const cl::Buffer position = filled(device, data.positions), pairs = filled(device, data.pairs),
                   slots = device.room(sizeof(cl_float4) * data.pairs.size()),
                   starts = filled(device, data.starts), entries = filled(device, data.entries),
                   forces = device.room(sizeof(cl_float4) * data.positions.size());
  const auto count = static_cast<cl_int>(data.pairs.size());
  return device.seconds(with(device, "write_down", position, pairs, count, slots), padded(data.pairs.size()),
                        group, times) +
         device.seconds(with(device, "gather", slots, starts, entries, forces), data.positions.size(), group,
                        times);
}

double serial_scan(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/scan.cl");
  const std::vector<cl_int> ones(data.positions.size(), 1);
  const cl::Buffer values = filled(device, ones), starts = filled(device, ones);
  const auto count = static_cast<cl_int>(ones.size());
  return device.seconds(with(device, "serial_scan", values, starts, count), 1, 1, times);
}

double block_scan(const Settings& settings, const LayoutData& data) {
  Device device(settings, "layout/scan.cl");
  constexpr cl_int block = 1024;
  const std::size_t blocks = padded((data.positions.size() + block - 1) / block);
  const std::vector<cl_int> ones(blocks * block, 1);
  const cl::Buffer values = filled(device, ones), starts = filled(device, ones), sums = filled(device, ones),
                   block_starts = filled(device, ones);
  return device.seconds(with(device, "reduce_blocks", values, sums, block), blocks, group, times) +
         device.seconds(with(device, "serial_scan", sums, block_starts, static_cast<cl_int>(blocks)), 1, 1,
                        times) +
         device.seconds(with(device, "fill_blocks", values, block_starts, starts, block), blocks, group,
                        times);
}

/// Zones `share` of the reach wide.
double count_partners(const Settings& settings, const LayoutData& data, double share) {
  Device device(settings, "layout/zones.cl");
  const ZonedData zoned = sort_by_zones(data, share);
  const cl::Buffer position = filled(device, zoned.positions), starts = filled(device, zoned.zone_starts),
                   counts = device.room(sizeof(cl_int) * zoned.positions.size());
  return device.seconds(with(device, "count_partners", position, starts, counts, zoned.zones,
                             zoned.inverse_width, zoned.around, zoned.reach2),
                        zoned.positions.size(), group, times);
}

double third(const Settings& settings, const LayoutData& data) {
  return count_partners(settings, data, 1.0 / 3.0);
}

double half(const Settings& settings, const LayoutData& data) {
  return count_partners(settings, data, 0.5);
}

double whole(const Settings& settings, const LayoutData& data) {
  return count_partners(settings, data, 1.0);
}

double twice(const Settings& settings, const LayoutData& data) {
  return count_partners(settings, data, 2.0);
}

struct Question {
  const char* what;
  const char* answer;
  Measure measure;
};

constexpr std::array questions{
    Question{"move a particle", "packed arrays", move_arrays},
    Question{"move a particle", "128-byte records", move_records},
    Question{"look at partners", "packed arrays", gather_arrays},
    Question{"look at partners", "128-byte records", gather_records},
    Question{"sum forces of pairs", "write down and gather", write_and_gather},
    Question{"sum forces of pairs", "compare and swap", compare_and_swap},
    Question{"scan", "blocks", block_scan},
    Question{"scan", "serial", serial_scan},
    Question{"find partners", "zones of the reach", whole},
    Question{"find partners", "zones of half the reach", half},
    Question{"find partners", "zones of a third", third},
    Question{"find partners", "zones of twice the reach", twice},
};

void add_question(const Settings& settings, const Question& question, std::int64_t particles, int round) {
  add_manual(std::string("layout/what:") + question.what + "/way:" + question.answer +
                 "/threads:" + std::to_string(thread_count(settings)) + "/size:" + std::to_string(particles) +
                 "/round:" + std::to_string(round),
             [&settings, measure = question.measure, particles](benchmark::State& state) {
               static const LayoutData data = layout_data(particles, settings.cache);
               const double seconds = measure(settings, data) / times;
               for (auto _ : state) state.SetIterationTime(seconds);
               state.counters["particles"] = static_cast<double>(data.positions.size());
               state.counters["launch_s"] = seconds;
               state.counters["ns_a_particle"] = 1e9 * seconds / static_cast<double>(data.positions.size());
             });
}

void add(const Settings& settings) {
  for (int round = 0; round < settings.rounds; ++round)
    for (const Question& question : questions)
      add_question(settings, question, settings.particles.at(0), round);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
