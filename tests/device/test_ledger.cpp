// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "device_fixture.hpp"
#include "opencl/pair_laws.hpp"
#include "scenes.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Momentum {
  Vec3 total = Vec3::Zero();
  double scale = 0.0;  ///< Σ m |v|
};

Momentum momentum(const Scene& scene, const Frame& frame) {
  Momentum p;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    const double mass = mass_of(scene.particles[i], scene);
    p.total += mass * frame.velocity[i];
    p.scale += mass * frame.velocity[i].norm();
  }
  return p;
}

using Case = std::tuple<Precision, std::string>;

class LedgerOf : public ::testing::TestWithParam<Case> {
 protected:
  Observations seen(const Scene& scene) {
    Request request;
    request.ledger = true;
    return observed(options_for(std::get<0>(GetParam())), scene, request);
  }
};

TEST_P(LedgerOf, MomentumChangesByTheImpulsesOfSupportsAndFields) {
  const Scene scene = varied_scene(std::get<1>(GetParam()));
  const Observations o = seen(scene);
  const Momentum before = momentum(scene, o.frames.front()), after = momentum(scene, o.frames.back());
  const Vec3 impulse = o.final_ledger->support_impulse + o.final_ledger->field_impulse;
  const double error = (after.total - before.total - impulse).norm();
  // Every step rounds each force once more on its way into the impulse than on its way into the velocity: as
  // many roundings of the momentum in motion as there are steps, adding up at random.
  EXPECT_LE(error,
            std::sqrt(varied_steps) * roundoff(std::get<0>(GetParam())) * (before.scale + after.scale));
  EXPECT_GT(o.final_ledger->support_impulse.norm(), 0.0);
}

TEST_P(LedgerOf, EnergyBalances) {
  Scene scene = varied_scene(std::get<1>(GetParam()));
  scene.run.step /= 4;
  const Observations o = seen(scene);
  const double kinetic = o.initial_ledger->kinetic;
  const double error = std::abs(o.final_ledger->balance() - o.initial_ledger->balance()) / kinetic;
  RecordProperty("relative_error", ::testing::PrintToString(error));
  // Work is booked over the whole kick, so all that is left is how the integrator follows the springs.
  // Verlet, at 512 steps a contact: a part of (ω h)² = 4e-5 of what springs hold at the end. The trapezoid's
  // energy grows in first order with every contact.
  const bool first_order = scene.run.integrator == Integrator::euler_trapezoid ||
                           scene.run.integrator == Integrator::euler_trapezoid_implicit_drag;
  EXPECT_LE(error, first_order ? 0.01 : 1e-5);
  EXPECT_GT(o.final_ledger->dissipated_normal, 0.05 * kinetic);
}

std::string case_name(const ::testing::TestParamInfo<Case>& param) {
  return std::string(name_of(std::get<0>(param.param))) + "_" + std::get<1>(param.param);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, LedgerOf,
    ::testing::Combine(::testing::Values(Precision::single_precision, Precision::double_precision),
                       ::testing::Values("boxed", "damped_friction", "fixed", "sticky", "implicit_drag",
                                         "leapfrog_verlet", "velocity_verlet", "rotating_gravity", "history",
                                         "turning_lammps", "turning_liggghts", "turning_damped", "hertz",
                                         "hertz_and_springs", "turning_in_rectangles", "drum", "paddle",
                                         "rolling_steadily")),
    case_name);
// Mixed books single's forces: from overlaps of double's positions with bodies and each kind of wall.
INSTANTIATE_TEST_SUITE_P(Mixed, LedgerOf,
                         ::testing::Combine(::testing::Values(Precision::mixed_precision),
                                            ::testing::Values("boxed", "sticky", "turning_liggghts",
                                                              "hertz_and_springs", "drum", "paddle")),
                         case_name);

}  // namespace
}  // namespace grainproof::opencl::testing
