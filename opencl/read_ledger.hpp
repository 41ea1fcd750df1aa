// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/observations.hpp"
#include "opencl/scene_image.hpp"

namespace grainproof::opencl {

struct LedgerBytes {
  Bytes tallies, sums, velocities, spins;
  Bytes wall_tallies, wall_sums;  ///< a slot for every particle and wall within reach
  Bytes corrections;              ///< empty where the integrator makes none
};

/// Adds up in id order, in double. `pending` is how long the last forces have acted beyond what the
/// integrator has booked, s.
Ledger read_ledger(const Scene& scene, const NearWalls& walls, const Frame& now, const LedgerBytes& bytes,
                   const Decoder& decoder, double pending);

}  // namespace grainproof::opencl
