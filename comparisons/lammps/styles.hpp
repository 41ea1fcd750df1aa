// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "comparisons/peers/atom_types.hpp"

namespace grainproof::lammps {

/// Name and arguments of the gran style that a pair of types has, in full precision: the same text after
/// `pair_style` and in fix wall/gran. Empty where the types never touch. Damping is m_eff γ, so γ is η
/// over the pair's effective mass.
std::string style_of(const Scene& scene, const peers::AtomType& a, const peers::AtomType& b);

}  // namespace grainproof::lammps
