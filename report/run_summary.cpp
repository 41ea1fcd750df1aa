// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/run_summary.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "comparisons/metrics/invariants.hpp"
#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

using nlohmann::json;

json vector_json(const Vec3& value) {
  return {value.x(), value.y(), value.z()};
}

json ledger_json(const Ledger& ledger) {
  return {{"kinetic", ledger.kinetic},
          {"elastic", ledger.elastic},
          {"cohesive", ledger.cohesive},
          {"gravity_work", ledger.gravity_work},
          {"drag_work", ledger.drag_work},
          {"wall_work", ledger.wall_work},
          {"dissipated_normal", ledger.dissipated_normal},
          {"dissipated_tangential", ledger.dissipated_tangential},
          {"dissipated_rolling", ledger.dissipated_rolling},
          {"balance", ledger.balance()},
          {"support_impulse", vector_json(ledger.support_impulse)},
          {"field_impulse", vector_json(ledger.field_impulse)}};
}

json ledgers_json(const Observations& seen) {
  if (!seen.initial_ledger || !seen.final_ledger) return nullptr;
  return {{"initial", ledger_json(*seen.initial_ledger)},
          {"final", ledger_json(*seen.final_ledger)},
          {"drift", seen.final_ledger->balance() - seen.initial_ledger->balance()}};
}

json energies_json(const std::optional<Energies>& energies) {
  if (!energies) return nullptr;
  return {{"kinetic", energies->kinetic},
          {"elastic", energies->elastic},
          {"gravitational", energies->gravitational ? json(*energies->gravitational) : json(nullptr)}};
}

json outcome_json(const Outcome& outcome) {
  if (outcome.status == Outcome::Status::completed) return {{"status", "completed"}};
  return {{"status", "went_wrong"},
          {"reason", outcome.reason},
          {"step", outcome.step},
          {"time", outcome.time},
          {"particles", outcome.particles}};
}

double loop_seconds(const Observations& seen) {
  return seen.counters.step_loop_wall_s > 0.0 ? seen.counters.step_loop_wall_s : seen.wall_s;
}

std::string contacts_text(const RunSummary& summary) {
  return grouped(summary.contacts.pairs) + " between particles, " + grouped(summary.contacts.walls) +
         " with walls, in the last frame";
}

void energy_lines(const RunSummary& summary, const Observations& seen, std::ostringstream& text) {
  if (!seen.initial_ledger || !seen.final_ledger) {
    if (const auto& last = summary.last_energies)
      text << "  energy         kinetic " << brief(last->kinetic) << " J, elastic " << brief(last->elastic)
           << " J, in the last frame\n";
    if (!summary.no_ledger_because.empty()) text << "  ledger         " << summary.no_ledger_because << "\n";
    return;
  }
  const Ledger& last = *seen.final_ledger;
  const double drift = last.balance() - seen.initial_ledger->balance();
  const Measured share = energy_error({}, seen, {});
  text << "  energy         kinetic " << brief(last.kinetic) << " J, elastic " << brief(last.elastic)
       << " J, dissipated "
       << brief(last.dissipated_normal + last.dissipated_tangential + last.dissipated_rolling)
       << " J; the ledger drifted by " << brief(drift) << " J"
       << (std::isfinite(share.value) ? ", " + brief(std::abs(share.value)) + " of its largest entry" : "")
       << "\n";
}

}  // namespace

std::string digest_text(std::uint64_t digest) {
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << digest;
  return text.str();
}

double cundall_number(const RunSummary& summary, const Observations& seen) {
  const double seconds = loop_seconds(seen);
  const std::int64_t steps = seen.counters.steps - summary.first_step;
  return seconds > 0.0 ? static_cast<double>(summary.particles * steps) / seconds : 0.0;
}

json machine_json(const Machine& machine) {
  return {{"system", machine.system},     {"processor", machine.processor},
          {"threads", machine.threads},   {"memory_bytes", machine.memory_bytes},
          {"compiler", machine.compiler}, {"grainproof", machine.version}};
}

json provenance_json(const Provenance& provenance) {
  return {{"engine", provenance.engine},
          {"precision", provenance.precision},
          {"device", provenance.device},
          {"version", provenance.version},
          {"variant", provenance.variant}};
}

json summary_json(const RunSummary& summary, const Observations& seen, const Machine& machine) {
  return {
      {"schema", 1},
      {"scene", summary.scene},
      {"outcome", outcome_json(seen.outcome)},
      {"particles", summary.particles},
      {"step", summary.step},
      {"step_because", summary.step_because.empty() ? json(nullptr) : json(summary.step_because)},
      {"steps", seen.counters.steps},
      {"first_step", summary.first_step},
      {"digest", summary.digest ? json(digest_text(*summary.digest)) : json(nullptr)},
      {"frames", summary.frames},
      {"wall_s", seen.wall_s},
      {"step_loop_wall_s", seen.counters.step_loop_wall_s},
      {"cundall_number", cundall_number(summary, seen)},
      {"energies",
       {{"initial", energies_json(summary.first_energies)}, {"final", energies_json(summary.last_energies)}}},
      {"ledger", ledgers_json(seen)},
      {"rebuilds", seen.counters.list_rebuilds},
      {"listed_pairs", seen.counters.listed_pairs},
      {"contacts", summary.contacts.pairs},
      {"wall_contacts", summary.contacts.walls},
      {"scalars", seen.scalars},
      {"peak_memory_bytes", summary.peak_memory},
      {"provenance", provenance_json(seen.provenance)},
      {"machine", machine_json(machine)}};
}

std::string summary_text(const RunSummary& summary, const Observations& seen, const Paint& paint) {
  const Provenance& from = seen.provenance;
  std::ostringstream text;
  text << paint.bold(summary.scene) << " on " << from.engine
       << (from.precision.empty() ? "" : ", " + from.precision + " precision")
       << (from.device.empty() ? "" : ", " + from.device) << "\n"
       << "  particles      " << grouped(summary.particles) << "\n"
       << "  steps          " << grouped(seen.counters.steps) << " of " << brief(summary.step) << " s\n"
       << (summary.step_because.empty() ? "" : "  step chosen    " + summary.step_because + "\n")
       << "  wall time      " << duration(seen.wall_s) << ", " << brief(cundall_number(summary, seen))
       << " particle-steps a second\n"
       << "  contacts       " << contacts_text(summary) << "\n"
       << "  list rebuilds  " << grouped(seen.counters.list_rebuilds) << "\n";
  if (summary.digest) text << "  digest         " << digest_text(*summary.digest) << "\n";
  for (const auto& [name, value] : seen.scalars) text << "  " << name << "  " << exact(value) << "\n";
  energy_lines(summary, seen, text);
  text << "  peak memory    " << brief(static_cast<double>(summary.peak_memory) / 1048576.0) << " MiB\n";
  return text.str();
}

}  // namespace grainproof::report
