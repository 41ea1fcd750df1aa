// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "model/observations.hpp"

namespace grainproof {

/// The energies of a ledger, in order; the first three are held, the others have been counted up.
inline constexpr std::array ledger_energies{&Ledger::kinetic,           &Ledger::elastic,
                                            &Ledger::cohesive,          &Ledger::gravity_work,
                                            &Ledger::drag_work,         &Ledger::wall_work,
                                            &Ledger::dissipated_normal, &Ledger::dissipated_tangential,
                                            &Ledger::dissipated_rolling};
inline constexpr std::array<const char*, 9> ledger_energy_names{
    "kinetic",           "elastic",   "cohesive",          "gravity_work",
    "drag_work",         "wall_work", "dissipated_normal", "dissipated_tangential",
    "dissipated_rolling"};
inline constexpr std::size_t ledger_energies_held = 3;

/// A ledger as numbers in a row: energies, then impulses: of supports, of fields, and of every wall its
/// impulse and its angular impulse.
std::vector<double> numbers_of(const Ledger& ledger);

/// Throws InputRefused where `numbers` cannot have come from a ledger.
Ledger ledger_of(const std::vector<double>& numbers);

}  // namespace grainproof
