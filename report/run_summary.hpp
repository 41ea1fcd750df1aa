// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "model/observations.hpp"
#include "model/scene.hpp"
#include "report/energies.hpp"
#include "report/machine.hpp"
#include "report/text_table.hpp"

namespace grainproof::report {

/// What `run` has to tell about one run of one scene.
struct RunSummary {
  std::string scene;  ///< the file's name
  std::int64_t particles = 0;
  std::int64_t frames = 0;
  double step = 0.0;                         ///< s
  std::string step_because = {};             ///< what chose it; empty where the scene says it outright
  std::int64_t first_step = 0;               ///< not 0 where a run went on from a checkpoint
  std::optional<std::uint64_t> digest = {};  ///< of the last state; none where an engine does not step
  ContactCount contacts;
  std::optional<Energies> first_energies = {}, last_energies = {};  ///< of the first and the last frame
  std::string no_ledger_because = {};  ///< and how to have one; empty where there is one or it is not wanted
  std::int64_t peak_memory = 0;        ///< bytes
};

/// Sixteen hexadecimal digits.
std::string digest_text(std::uint64_t digest);

/// Particles times steps per second of wall time in the step loop.
double cundall_number(const RunSummary& summary, const Observations& seen);

/// docs/results.md, summary.json.
nlohmann::json summary_json(const RunSummary& summary, const Observations& seen, const Machine& machine);

/// The same for a person, a few aligned lines.
std::string summary_text(const RunSummary& summary, const Observations& seen, const Paint& paint);

nlohmann::json machine_json(const Machine& machine);
nlohmann::json provenance_json(const Provenance& provenance);

}  // namespace grainproof::report
