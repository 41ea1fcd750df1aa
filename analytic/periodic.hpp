// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "analytic/solution.hpp"

namespace grainproof::analytic {

/// A scene whose particles stay clear of every periodic face is that scene without them. Refuses one in
/// which a body, looked at 1000 times over the run, reaches a periodic face.
Solution solve_away_from_faces(Solution (*solve)(const Scene&, double), const Scene& scene, double until);

}  // namespace grainproof::analytic
