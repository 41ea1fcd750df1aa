// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/free_motion.hpp"

/// Nothing but constant gravity: x = x0 + v0 t + g t²/2 (fields.1).
namespace grainproof::analytic {

Solution free_fall(const Scene& scene, double until) {
  if (!std::holds_alternative<NoFlow>(scene.flow)) return Solution::no("a fluid acts on the particles");
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  if (!gravity) return Solution::no("gravity is not constant");
  return free_motion(scene, gravity->acceleration, UniformFlow{0.0, Vec3::Zero()}, until);
}

}  // namespace grainproof::analytic
