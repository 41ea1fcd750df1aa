// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/engine.hpp"

#include <utility>

#include "comparisons/liggghts/deck.hpp"
#include "comparisons/liggghts/expressible.hpp"

namespace grainproof {

LiggghtsEngine::LiggghtsEngine(peers::ProgramOptions options)
    : ScriptEngine({"liggghts", "LIGGGHTS", "liggghts", "Version ", liggghts::expressible,
                    liggghts::scene_deck, liggghts::variant_of},
                   std::move(options)) {}

}  // namespace grainproof
