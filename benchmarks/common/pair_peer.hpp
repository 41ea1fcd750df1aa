// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "benchmarks/common/pair_gas.hpp"
#include "benchmarks/common/peer_deck.hpp"

namespace grainproof::bench {

/// What a peer makes of a pair gas.
struct PeerPoint {
  std::vector<Vec3> velocity;  ///< of each particle, at the end
  std::vector<double>
      restitution;  ///< that each pair should leave with: its dashpot is one rate for all masses
  double loop_s = 0.0;
};

/// Why not, or empty.
std::string peer_lacks(PeerProgram program, const PairGas& gas);

/// Throws EngineFailed with what the program said last.
PeerPoint run_peer(PeerProgram program, const PairGas& gas, const Scene& scene, std::int64_t steps,
                   int processes);

}  // namespace grainproof::bench
