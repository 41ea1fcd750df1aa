// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "reference_cpu/neighbours/pair_list.hpp"

namespace grainproof::reference {

/// Every pair looked at: the search that needs no belief.
void list_all_pairs(const Bodies& bodies, const PeriodicBox& box, double skin, PairList& list);

}  // namespace grainproof::reference
