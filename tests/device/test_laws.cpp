// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double mu = 0.6, sliding_stiffness = 1e5, weight_g = 9.81, launch = 1.0;
const double mass = sphere_mass(density, diameter);

/// A sphere at rest in its own dent on the floor, launched along x at 1 m/s.
Scene sliding_scene(const FrictionLaw& friction, double end) {
  Scene scene = settling_scene(1);
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}, false}, friction, NoCohesion{}});
  scene.particles[0].position.z() -= mass * weight_g / stiffness;
  scene.particles[0].velocity = {launch, 0, 0};
  scene.run.end = end;
  scene.run.sample_times = {0.0, end};
  return scene;
}

class Laws : public ::testing::TestWithParam<Precision> {
 protected:
  double speed_after(const FrictionLaw& friction, double end) {
    const auto seen = observed(options_for(GetParam()), sliding_scene(friction, end));
    time_ = seen.frames.back().time;
    return seen.frames.back().velocity[0].x();
  }
  /// 32 roundings of the launch speed.
  double tolerance() const { return 32 * roundoff(GetParam()) * launch; }

  /// Single keeps what rounding leaves out of a velocity; double loses half a digit at each of two kicks a
  /// step.
  double steps_tolerance() const {
    const double steps = time_ / sliding_scene(Frictionless{}, 1).run.step;
    return GetParam() == Precision::double_precision ? 2 * steps * double_roundoff * launch : tolerance();
  }

  double time_ = 0.0;
};

TEST_P(Laws, EveryFrictionSlowsAFastSphereByTheCoulombLimit) {
  for (const FrictionLaw& friction :
       {FrictionLaw{DynamicFriction{mu}}, FrictionLaw{StepFriction{mu, 1e5}},
        FrictionLaw{CollisionTimeFriction{mu, 1e5}}, FrictionLaw{DampedFriction{mu, 1e5}}}) {
    const double speed = speed_after(friction, 0.05);
    EXPECT_LE(std::abs(speed - (launch - mu * weight_g * time_)), steps_tolerance()) << friction.index();
  }
}

/// Below the Coulomb limit a static friction c |u| slows exponentially at the rate c/m.
void expect_creep(double speed, double time, double c, double step) {
  const double slowest_sliding = mu * mass * weight_g / c;
  const double since = (launch - slowest_sliding) / (mu * weight_g);
  ASSERT_GT(time, since);
  const double expected = slowest_sliding * std::exp(-c / mass * (time - since));
  EXPECT_LE(std::abs(speed - expected),
            c / mass * step * slowest_sliding);  // the integrator's own first order
  EXPECT_GT(speed, 0.2 * slowest_sliding);
}

TEST_P(Laws, StaticFrictionsCreepAtTheirOwnRates) {
  const double step = sliding_scene(Frictionless{}, 1).run.step;
  const double contact = std::numbers::pi * std::sqrt(mass / stiffness);
  const double log_e = std::log(0.8);
  const double eta =
      -2 * log_e * std::sqrt(mass * stiffness / (std::pow(std::numbers::pi, 2) + log_e * log_e));
  const struct {
    FrictionLaw law;
    double c;
  } variants[] = {{StepFriction{mu, 1e5}, sliding_stiffness * step},
                  {CollisionTimeFriction{mu, 1e5}, sliding_stiffness * contact},
                  {DampedFriction{mu, 1e5}, sliding_stiffness * contact + eta}};
  for (const auto& [law, c] : variants) {
    const double slowest = mu * mass * weight_g / c;
    const double when = (launch - slowest) / (mu * weight_g) + mass / c;
    const double speed = speed_after(law, when);
    expect_creep(speed, time_, c, step);
  }
}

TEST_P(Laws, DampedFrictionDiffersFromCollisionTimeByTheDashpot) {
  const double when = 0.1712;
  EXPECT_LT(speed_after(DampedFriction{mu, 1e5}, when), speed_after(CollisionTimeFriction{mu, 1e5}, when));
}

TEST_P(Laws, CohesivePairLeavesWithTheExactSpeed) {
  Scene scene = head_on_scene(0.8, 512);
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.8}, false}, Frictionless{}, LinearCohesion{1e3}});
  for (Particle& p : scene.particles) p.effect_diameter = 0.12;
  scene.particles[1].position.x() = 0.1203;
  scene.particles[1].velocity.x() = -1;
  scene.run.end = 0.1;
  scene.run.sample_times = {0.0, scene.run.end};
  const double left = observed(options_for(GetParam()), scene).frames.back().velocity[1].x();
  // E5: leaves body contact with 0.922736237 m/s, then loses k_c L²/m on the way out of reach.
  const double exact = std::sqrt(std::pow(0.922736237, 2) - 1e3 * 0.02 * 0.02 / mass);
  EXPECT_LE(std::abs(left / exact - 1),
            1e-3);  // first order: 7.2e-4 at 256 steps per contact, this is at 512
}

TEST_P(Laws, NoTensionReboundsWithTheRestitutionAskedFor) {
  for (const double restitution : {0.05, 0.3, 0.8, 1.0}) {
    Scene scene = head_on_scene(0.8, 2048);
    scene.contacts.set(
        0, 0, {LinearNormal{stiffness, Restitution{restitution}, true}, Frictionless{}, NoCohesion{}});
    scene.run.end *= 2;
    scene.run.sample_times = {0.0, scene.run.end};
    const double left = observed(options_for(GetParam()), scene).frames.back().velocity[1].x() / 2;
    EXPECT_LE(std::abs(left - restitution), 2e-3) << restitution;  // a step's share of a strong dashpot
  }
}

TEST_P(Laws, ObliqueHitOnAWallTurnsByTheFrictionImpulse) {
  Scene scene = settling_scene(1);
  scene.gravity = ConstantGravity{Vec3::Zero()};
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.8}, true}, DynamicFriction{0.3}, NoCohesion{}});
  scene.particles[0].position.z() = 0.0503;
  scene.particles[0].velocity = {3, 4, -1};
  scene.run.end = 0.03;
  scene.run.step /= 8;
  scene.run.sample_times = {0.0, scene.run.end};
  const Vec3 left = observed(options_for(GetParam()), scene).frames.back().velocity[0];
  const double slip = 5 - 0.3 * (1 + left.z());
  EXPECT_LE(std::abs(std::hypot(left.x(), left.y()) - slip), 5 * tolerance());
  EXPECT_LE(std::abs(left.x() / left.y() - 0.75), tolerance());
}

GRAINPROOF_IN_EVERY_PRECISION(Laws);

}  // namespace
}  // namespace grainproof::opencl::testing
