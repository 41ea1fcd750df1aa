// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/laws/flow.hpp"

#include <cmath>
#include <numbers>

#include "model/laws.hpp"

namespace grainproof::reference {
namespace {

// Andrews 6.1-6.3, each argument a (x + π/2a) = a x + π/2. The third component ends in a cosine of z
// alone: the published kernel has another form, which is not free of divergence (E17).
Vec3 taylor_green(const TaylorGreenFlow& flow, const Vec3& position) {
  const Vec3 phase = flow.wave_number * position + Vec3::Constant(0.5 * std::numbers::pi);
  const Vec3 sine = phase.array().sin();
  const Vec3 cosine = phase.array().cos();
  return flow.amplitude * Vec3(cosine.x() * sine.y() * sine.z(), sine.x() * cosine.y() * sine.z(),
                               -2.0 * sine.x() * sine.y() * cosine.z());
}

}  // namespace

Vec3 fluid_velocity(const Flow& flow, const Vec3& position) {
  return std::visit(
      Overloaded{[](const NoFlow&) -> Vec3 { return Vec3::Zero(); },
                 [](const UniformFlow& uniform) -> Vec3 { return uniform.velocity; },
                 [&](const TaylorGreenFlow& vortices) { return taylor_green(vortices, position); }},
      flow);
}

}  // namespace grainproof::reference
