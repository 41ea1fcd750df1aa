// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_roofline.hpp"

#include "app/bench_suites.hpp"

namespace grainproof::app {
namespace {

using nlohmann::json;

constexpr double state_numbers = 18.0;  // position, velocity and spin, read and written
constexpr double spring_numbers = 6.0;  // of a touching pair, read and written
constexpr double partner_bytes = 4.0;   // index of a listed pair
constexpr double flops_a_particle = 40.0;
constexpr double flops_a_listed_pair = 10.0;
constexpr double flops_a_touching_pair = 120.0;

/// A particle's share: a settled bed has four contacts a particle, the gas next to none.
double touching_pairs(const std::string& scene) {
  return scene.starts_with("bed") ? 2.0 : 0.02;
}

/// Largest of a kind for the threads of a row; 0 where none was measured.
double rate_of(const json& rows, const char* what, const json& threads) {
  for (const json& row : rows)
    if (row.at("suite") == "roofline" && row.at("what") == what && row.at("threads") == threads &&
        row.contains("rate"))
      return row.at("rate").get<double>();
  return 0.0;
}

void add_shares_to(json& row, double copy_rate, double flop_rate) {
  const double listed = row.at("listed_pairs").get<double>();
  const double touching = touching_pairs(row.at("scene").get<std::string>());
  const double number = row.at("precision") == "double" ? 8.0 : 4.0;
  const double bytes = number * (state_numbers + spring_numbers * touching) + partner_bytes * listed;
  const double flops = flops_a_particle + flops_a_listed_pair * listed + flops_a_touching_pair * touching;
  const double speed = row.at("cundall_number").get<double>();
  row["bytes_per_particle_step"] = bytes;
  row["flops_per_particle_step"] = flops;
  if (copy_rate > 0.0) row["bandwidth_share"] = bytes * speed / copy_rate;
  if (flop_rate > 0.0) row["flops_share"] = flops * speed / flop_rate;
}

}  // namespace

void measure_roofline(BenchSession& session) {
  for (int threads : thread_counts(session))
    session.run({.suite = "roofline",
                 .what = "what the device can do, " + std::to_string(threads) + " threads",
                 .threads = threads,
                 .rounds = 2});
}

void add_shares(json& rows) {
  const json all = rows;
  for (json& row : rows) {
    if (!row.contains("listed_pairs") || !row.contains("cundall_number") || !row.contains("scene")) continue;
    const json threads =
        row.at("engine") == "reference" ? json(1) : row.value("threads", row.value("processes", json(0)));
    add_shares_to(row, rate_of(all, "copy, bytes a second", threads),
                  rate_of(all, "multiply-add, flops a second", threads));
  }
}

}  // namespace grainproof::app
