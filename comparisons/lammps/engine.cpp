// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/lammps/engine.hpp"

#include <utility>

#include "comparisons/lammps/deck.hpp"
#include "comparisons/lammps/expressible.hpp"

namespace grainproof {

LammpsEngine::LammpsEngine(peers::ProgramOptions options)
    : ScriptEngine({"lammps", "LAMMPS", "lammps", "LAMMPS (", lammps::expressible, lammps::scene_deck,
                    lammps::variant_of},
                   std::move(options)) {}

}  // namespace grainproof
