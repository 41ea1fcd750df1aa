// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string_view>

#include "model/engine.hpp"

/// Errors that LAMMPS and LIGGGHTS were once found to have on one head-on collision of equal spheres that
/// begins with a step. A live run that does not reproduce them is not the run that it is taken for.
namespace grainproof::bench {

enum class KnownQuantity { rebound, peak_overlap };

struct KnownError {
  double restitution;
  KnownQuantity quantity;
  double steps_per_contact;
  double error;  ///< relative to the exact value
};

std::span<const KnownError> known_errors();

std::string_view name_of(KnownQuantity quantity);

/// The error that `engine` makes at that point now. Throws EngineFailed where it does not finish.
double error_now(Engine& engine, const KnownError& known);

}  // namespace grainproof::bench
