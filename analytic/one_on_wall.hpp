// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "model/scene.hpp"

/// What closed forms of one sphere on one wall that moves have in common.
namespace grainproof::analytic {

/// Why this is no scene of one moving sphere and one wall, with a linear contact without cohesion, in
/// constant gravity and no fluid, without orientations; "" where it is one.
std::string why_not_one_on_wall(const Scene& scene);

/// Of the only sphere and the only wall. Throws where `why_not_one_on_wall` has a reason.
const ContactLaws& laws_on_wall(const Scene& scene);

/// kg, of the only sphere.
double mass_on_wall(const Scene& scene);

/// Why the sphere does not start at the overlap where `push` (N, positive) holds its spring; "" where it
/// does.
std::string why_not_at_rest(const Scene& scene, double push, double overlap);

}  // namespace grainproof::analytic
