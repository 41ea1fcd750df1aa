// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "model/checkpoint.hpp"

namespace grainproof::app {

/// Where two states first differ: by particle, and of it by position, velocity, spin, orientation, contacts.
struct BitDifference {
  std::int64_t step = 0;
  double time = 0.0;  ///< s
  std::int64_t particle = 0;
  std::string what;  ///< "velocity x"
  double first = 0.0, second = 0.0;
  std::int64_t particles = 0;  ///< how many differ
};

/// Nothing where all bits are the same; +0 and −0 are not. Throws InputRefused for other particles.
std::optional<BitDifference> bit_difference(const State& first, const State& second);

/// One of the two that are compared.
struct Contestant {
  SteppingEngine& engine;
  const Scene& scene;
};

/// The first step at which the states of two runs differ, up to step `last`: found by looking now and then,
/// and then by halves, from checkpoints where the engines have them, else from the start. Runs that part and
/// meet again between two looks are taken for the same.
std::optional<BitDifference> first_difference(const Contestant& one, const Contestant& other,
                                              std::int64_t last,
                                              const std::function<void(std::int64_t)>& progress);

}  // namespace grainproof::app
