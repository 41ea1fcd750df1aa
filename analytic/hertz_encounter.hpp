// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/encounter.hpp"
#include "analytic/hertz.hpp"

namespace grainproof::analytic {

/// The two bodies of an encounter by Hertz' law.
HertzPair hertz_pair_of(const Scene& scene, const Encounter& encounter);

}  // namespace grainproof::analytic
