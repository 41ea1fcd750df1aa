// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "comparisons/peers/atom_types.hpp"
#include "model/engine.hpp"

/// Commands that LIGGGHTS and LAMMPS read alike.
namespace grainproof::peers {

/// Full precision, so that the very number is read back.
std::ostringstream exact_text();

std::string name_with(const char* stem, int number);

/// Data file (positions, velocities, spins) and list of sample steps of one scene, in `folder`.
void write_inputs(const Scene& scene, const Request& request, const TypeTable& table,
                  const std::filesystem::path& folder, int number);

/// From `atom_modify` to `neigh_modify`; `talk` is how ghosts are told to carry velocities, `bins` whether
/// pairs are to be found by bins however few there are.
std::string set_up(const Scene& scene, const char* talk, bool bins, int number);

/// Group `moving` and its integration: nve/sphere where bodies turn, else nve, which leaves at zero the
/// spin that friction would give. Fixed particles are frozen.
std::string motion(const Scene& scene, const TypeTable& table);

/// Weight and drag; docs/laws/fields.md: (m/τ)(u_f − u) = 3π μ_f d (u_f − u).
std::string fields(const Scene& scene, const TypeTable& table);

/// Time step, dump and run; `format` is what stands before a dump's format of lines.
std::string output_and_run(const Scene& scene, const Request& request, const char* format, int number);

std::string dump_name(int number);

/// What the deck prints into the log when a scene is through.
std::string done_marker(int number);

}  // namespace grainproof::peers
