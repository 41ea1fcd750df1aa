// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "model/state.hpp"

namespace grainproof::reference {

/// 64 bits over every bit of a state.
std::uint64_t digest_of(const State& state);

}  // namespace grainproof::reference
