// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// A sphere that hits a rigid floor, sliding all the while: Chung and Ooi 2011, cases 5 and 6. Without a
/// tangential dashpot, which at the onset of a fast slip kicks before the spring is at its limit.
struct Strike {
  Elasticity elasticity;
  double density, radius, restitution, friction;
  double normal_speed, tangential_speed, spin;  ///< spin about y
};

struct Rebound {
  double normal_speed, tangential_speed, spin;
};

Scene strike_scene(const Strike& strike, CoulombLimit limit) {
  const double modulus =
      strike.elasticity.youngs_modulus / (1.0 - std::pow(strike.elasticity.poisson_ratio, 2));
  const double mass = sphere_mass(2.0 * strike.radius, strike.density);
  const double overlap = std::pow(
      15.0 * mass * std::pow(strike.normal_speed, 2) / (16.0 * modulus * std::sqrt(strike.radius)), 0.4);
  Scene scene = empty_scene({}, 2.943275 * overlap / strike.normal_speed / 2000.0);
  scene.rotation = true;
  scene.materials = {{"sphere", strike.density, strike.elasticity}, {"rigid", 1.0, Elasticity{1e30, 0.0}}};
  scene.contacts = ContactTable(2);
  const ContactLaws laws{.normal = HertzNormal{Restitution{strike.restitution}},
                         .friction = HistoryFriction{strike.friction, 0.0, 0.0, limit}};
  scene.contacts.set(0, 0, laws);
  scene.contacts.set(0, 1, laws);
  scene.walls.push_back({"floor", 1, Plane{Vec3::Zero(), Vec3::UnitZ()}});
  add_particle(scene, 2.0 * strike.radius, {0.0, 0.0, strike.radius},
               {strike.tangential_speed, 0.0, -strike.normal_speed})
      .angular_velocity = {0.0, strike.spin, 0.0};
  return scene;
}

Rebound rebound_of(const Strike& strike, CoulombLimit limit) {
  const Scene scene = strike_scene(strike, limit);
  const auto run = start(scene);
  do run->advance(1);
  while (run->frame().position[0].z() < strike.radius);
  run->advance(1);
  const Frame frame = run->frame();
  return {frame.velocity[0].z(), frame.velocity[0].x(), frame.angular_velocity[0].y()};
}

constexpr Elasticity steel{208e9, 0.30}, polyethylene{1e9, 0.40};
constexpr std::array both_limits{CoulombLimit::spring, CoulombLimit::spring_and_dashpot};

// r ω'/(μ V_n) = −5 in their sense of turning, and the surface loses 7 μ V_n. Theirs counts ω so that
// friction makes it negative; a sphere sliding along +x is turned about +y.
TEST(GrossSliding, ElasticStrikeTurnsBySpinAndSurfaceSpeedOfChungAndOoi) {
  for (const auto& [elasticity, density] : {std::pair{steel, 7850.0}, std::pair{polyethylene, 1400.0}})
    for (const double over_limit : {8.0, 15.0})
      for (const CoulombLimit limit : both_limits) {
        const Strike strike{elasticity, density, 1e-5, 1.0, 0.3, 5.0, over_limit * 0.3 * 5.0, 0.0};
        const Rebound after = rebound_of(strike, limit);
        const double unit = 0.3 * 5.0;
        EXPECT_NEAR(1e-5 * after.spin / unit, 5.0, 1e-5);
        EXPECT_NEAR((after.tangential_speed - 1e-5 * after.spin) / unit, over_limit - 7.0, 1e-5);
        EXPECT_NEAR(after.normal_speed, 5.0, 5e-6);
      }
}

constexpr Elasticity aluminium{70e9, 0.33};

/// Impulse of |F_n| over m V_n: (1 + e) and twice what the damped contact pulls before it ends.
double normal_impulse(Strike strike) {
  strike.friction = 0.0;
  const Scene scene = strike_scene(strike, CoulombLimit::spring);
  const auto run = start(scene);
  double before = -strike.normal_speed, sum = 0.0;
  do {
    run->advance(1);
    const double now = run->frame().velocity[0].z();
    sum += std::abs(now - before);
    before = now;
  } while (run->frame().position[0].z() < strike.radius);
  return sum / strike.normal_speed;
}

// Case 6, where the published 2.5 (1 + e) = 3.75 is that of a contact that never pulls. Tsuji's dashpot
// pulls in the end, and the limit is on |F_n|, whose impulse is 1.60 m V_n at e = 0.5.
TEST(GrossSliding, SpinningSphereIsKickedByTheImpulseOfTheNormalForceWithItsPull) {
  for (const CoulombLimit limit : both_limits)
    for (const double spin : {-60.0, -100.0}) {
      const Strike strike{aluminium, 2700.0, 0.1, 0.5, 0.4, 0.2, 0.0, spin};
      const Rebound after = rebound_of(strike, limit);
      const double impulse = normal_impulse(strike);
      EXPECT_NEAR(impulse, 1.60, 0.005);
      EXPECT_NEAR(after.tangential_speed / (0.4 * 0.2), -impulse, 1e-3 * impulse);
      EXPECT_NEAR(0.1 * (after.spin - spin) / (0.4 * 0.2), 2.5 * impulse, 1e-3 * 2.5 * impulse);
    }
}

// Case 7: equal spheres that turn against each other mesh like gears, and nothing but the rebound happens.
TEST(GrossSliding, OppositeSpinsOfEqualSpheresLeaveEachOtherAlone) {
  const Strike strike{aluminium, 2700.0, 0.1, 0.5, 0.4, 0.2, 0.0, 0.0};
  Scene scene = strike_scene(strike, CoulombLimit::spring);
  scene.walls.clear();
  scene.particles.clear();
  add_particle(scene, 0.2, {-0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}).angular_velocity = {0.0, 30.0, 0.0};
  add_particle(scene, 0.2, {0.1, 0.0, 0.0}, {-0.2, 0.0, 0.0}).angular_velocity = {0.0, -30.0, 0.0};
  const Frame frame = frame_after(scene, 4000);
  EXPECT_NEAR(frame.velocity[1].x(), 0.1, 1e-4);
  EXPECT_EQ(frame.velocity[0].z(), 0.0);
  EXPECT_EQ(frame.angular_velocity[0].y(), 30.0);
  EXPECT_EQ(frame.angular_velocity[1].y(), -30.0);
}

}  // namespace
}  // namespace grainproof::testing
