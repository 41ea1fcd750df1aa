// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

namespace grainproof::liggghts {

enum class Rolling { off, cdt, epsd2 };

/// LIGGGHTS' contact models for all contacts of a deck.
struct Models {
  bool hertz = false;
  bool history = false;
  bool friction = false;
  bool no_tension = false;
  bool tangential_damping = false;  ///< hertz: Mindlin's dashpot
  Rolling rolling = Rolling::off;
};

/// For the contacts of one pair of materials.
Models models_of(const ContactLaws& laws);

/// Of a Hertz contact, as the restitution that LIGGGHTS makes the same dashpot from; NaN where none does.
double restitution_of(const Dissipation& dissipation);

/// For a scene, whose contacts all need the same.
Models models_of(const Scene& scene);

}  // namespace grainproof::liggghts
