// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "model/scene.hpp"
#include "model/sections.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/contact_history.hpp"

/// Between memories as everyone names them, by ids, and as the engine holds them, by indices.
namespace grainproof::reference {

/// What the scene's contacts remember at the start.
std::vector<ContactHistory::Memory> memories_of(const Scene& scene);

/// Pairs by rising ids; after them wall by wall, by rising ids.
std::vector<ContactMemory> memories_by_id(const Scene& scene, const ContactHistory& history,
                                          const Bodies& bodies);

/// As they are held, for a run that goes on from a checkpoint of this engine.
void pack_memories(Sections& own, const ContactHistory& history);
std::vector<ContactHistory::Memory> unpacked_memories(const Sections& own);

}  // namespace grainproof::reference
