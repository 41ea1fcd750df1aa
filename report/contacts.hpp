// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::report {

struct ContactCount {
  std::int64_t pairs = 0;  ///< particles whose bodies overlap
  std::int64_t walls = 0;  ///< (particle, wall) whose bodies overlap
};

/// Calls `visit(particle, other, overlap)` for all that touches in a frame, periodic images included: `other`
/// is a particle before it, or −1 − index of a wall. No engine uses it.
void each_contact(const Scene& scene, const Frame& frame,
                  const std::function<void(std::size_t, std::int64_t, double)>& visit);

/// Counts what touches in a frame, periodic images included. For summaries: no engine uses it.
ContactCount count_contacts(const Scene& scene, const Frame& frame);

}  // namespace grainproof::report
