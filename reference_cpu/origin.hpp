// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"

namespace grainproof::reference {

/// Where a run counts coordinates from: zero, or the corner of a domain that lies away from it, so that no
/// digits are spent on the distance. Zero where a flow is bound to it.
Vec3 origin_of(const Scene& scene);

/// The same scene in coordinates counted from `origin`.
Scene counted_from(const Vec3& origin, Scene scene);

/// A place of the scene, from one counted from `origin`. Rounding takes none across a periodic face.
Vec3 place_of(const Vec3& counted, const Vec3& origin, const Domain& counted_domain);

}  // namespace grainproof::reference
