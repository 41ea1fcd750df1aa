// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>

#include "model/scene.hpp"

namespace grainproof::bench {

enum class PeerProgram { lammps, liggghts };

/// Positions and velocities as both programs read them.
void write_peer_data(const Scene& scene, const std::filesystem::path& file);

/// Its lines that say what acts, in the scenes of scenes.hpp.
std::string peer_contacts(PeerProgram program, const Scene& scene);

/// A deck as a user who wants speed writes it: one plain style, spatial sorting left on, nothing written
/// down. Runs `warm_up` steps, then `steps`. For the scenes of scenes.hpp; the data file is called data.
std::string peer_deck(PeerProgram program, const Scene& scene, double skin, std::int64_t warm_up,
                      std::int64_t steps);

}  // namespace grainproof::bench
