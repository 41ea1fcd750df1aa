// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "benchmarks/common/pair_gas.hpp"
#include "benchmarks/common/peer_deck.hpp"

namespace grainproof::bench {

/// Why a peer cannot run a pair gas, or empty.
std::string peer_lacks(PeerProgram program, const PairGas& gas);

/// The lines of a deck that say what acts in a pair gas.
std::string pair_contacts(PeerProgram program, const PairGas& gas, const Scene& scene);

/// That each pair should leave with: a peer's dashpot is one rate for all masses.
std::vector<double> peer_restitutions(const PairGas& gas, const Scene& scene);

struct PeerRun {
  std::vector<Vec3> velocity;  ///< of each particle, at the end
  double loop_s = 0.0;
};

/// From the scene's start to its end, with `contacts` as what acts. Throws EngineFailed with what the program
/// said last.
PeerRun run_peer(PeerProgram program, const std::string& contacts, const Scene& scene, std::int64_t steps,
                 int processes);

}  // namespace grainproof::bench
