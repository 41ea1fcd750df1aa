// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Single contacts whose springs can be worked out by hand.
#include <cmath>

#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double mu = 0.5, k_t = 8e4, slip = 0.2;
const double mass = sphere_mass(density, diameter);

/// A sphere on a floor without gravity, 1 mm deep, sliding along x; it neither loses nor wins height.
Scene scratching_scene(const HistoryFriction& friction, double speed = slip) {
  Scene scene = settling_scene(1);
  scene.gravity = ConstantGravity{Vec3::Zero()};
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{1.0}, false}, friction, NoCohesion{}});
  scene.particles[0].position.z() -= 1e-3;
  scene.particles[0].velocity = {speed, 0, 0};
  scene.run.step = 1e-5;
  return scene;
}

HistoryFriction law(CoulombLimit limit, double ratio = 0.0) {
  return {mu, k_t, ratio, limit, TorqueArm::radius, SpringTurn::project_and_rescale};
}

using Way = std::tuple<Precision, Path>;

class History : public ::testing::TestWithParam<Way> {
 protected:
  State after(const Scene& scene, std::int64_t steps) const {
    EngineOptions options = options_for(std::get<0>(GetParam()));
    options.path = std::get<1>(GetParam());
    OpenClEngine engine(options);
    const auto run = engine.start(scene, {});
    run->advance(steps);
    return run->state();
  }
  double tolerance() const { return 32 * roundoff(std::get<0>(GetParam())); }
};

TEST_P(History, StartsAtZeroWithTheForcesOfStepZero) {
  EngineOptions options = options_for(std::get<0>(GetParam()));
  options.path = std::get<1>(GetParam());
  OpenClEngine engine(options);
  const auto run = engine.start(scratching_scene(law(CoulombLimit::spring)), {});
  run->digest();
  const State state = run->state();
  ASSERT_EQ(state.contacts.size(), 1u);
  EXPECT_EQ(state.contacts[0].first, 0);
  EXPECT_EQ(state.contacts[0].second, -1);
  EXPECT_EQ(state.contacts[0].tangential_displacement, Vec3(0, 0, 0));
}

TEST_P(History, SticksAsASpringOfFirstStepSpeedTimesStep) {
  const State state = after(scratching_scene(law(CoulombLimit::spring_and_dashpot)), 1);
  ASSERT_EQ(state.contacts.size(), 1u);
  const Vec3 stretched = state.contacts[0].tangential_displacement;
  EXPECT_LE(std::abs(stretched.x() - slip * 1e-5), tolerance() * slip * 1e-5);
  EXPECT_EQ(stretched.y(), 0.0);
  // The half kick at the end of the step is the spring's: v' = v − (k_t v h/m) h/2.
  const double lost = k_t * slip * 1e-5 / mass * 0.5e-5;
  EXPECT_LE(std::abs(slip - state.velocity[0].x() - lost), tolerance() * slip);
}

// A spring in floats balances a weight along the floor to half a last digit only. What that leaves slips, by
// less a step than the spring's last digit, and has to stretch it all the same.
TEST_P(History, HoldsASphereAtRestForGood) {
  Scene scene = settling_scene(1);
  scene.gravity = ConstantGravity{Vec3(1.37, 0.0, -9.81)};
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.3}, false},
                      law(CoulombLimit::spring_and_dashpot, 1.0), NoCohesion{}});
  scene.run.step = 1e-5;
  EngineOptions options = options_for(std::get<0>(GetParam()));
  options.path = std::get<1>(GetParam());
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  run->advance(20000);
  const Vec3 settled = run->state().position[0];
  run->advance(20000);
  EXPECT_LT((run->state().position[0] - settled).norm(), 2e-9 * diameter);
}

TEST_P(History, EveryStepStretchesExactlyOnce) {
  // Undamped and sticking, the leap-frog spring is a rotation by 2 asin(ω h/2) a step.
  const double h = 1e-5, omega = std::sqrt(k_t / mass), turn = 2 * std::asin(omega * h / 2);
  const Scene scene = scratching_scene(law(CoulombLimit::spring), 0.01);
  for (const int steps : {2, 37, 400}) {
    const double there = after(scene, steps).contacts.at(0).tangential_displacement.x();
    const double expected = 0.01 * h * std::sin(steps * turn) / std::sin(turn);
    EXPECT_LE(std::abs(there - expected), 8 * tolerance() * 0.01 / omega) << steps;
  }
}

TEST_P(History, SlidesAtTheLimitOfTheSpringAlone) {
  const State state = after(scratching_scene(law(CoulombLimit::spring, 1.0), 5.0), 300);
  const Vec3 x = state.position[0];
  const double limit = mu * stiffness * (0.05 - x.z());
  const double stretched = state.contacts.at(0).tangential_displacement.x();
  EXPECT_LE(std::abs(stretched - limit / k_t), 64 * tolerance() * limit / k_t);
}

TEST_P(History, SpringAndDashpotTogetherHoldTheLimit) {
  Scene scene = scratching_scene(law(CoulombLimit::spring_and_dashpot, 0.7), 5.0);
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Damping{100.0}, false},
                      law(CoulombLimit::spring_and_dashpot, 0.7), NoCohesion{}});
  scene.run.integrator = Integrator::leapfrog_verlet;
  const State before = after(scene, 300), now = after(scene, 301);
  // What the spring keeps plus 70 N s/m times the slip is the limit; forces are taken with the velocities
  // held.
  const double pressing = stiffness * (0.05 - before.position[0].z()) - 100.0 * before.velocity[0].z();
  const double held = k_t * before.contacts.at(0).tangential_displacement.x() + 70.0 * before.velocity[0].x();
  EXPECT_LE(std::abs(held - mu * std::abs(pressing)), 64 * tolerance() * 70.0 * 5.0);
  EXPECT_LE(std::abs(before.velocity[0].x() - now.velocity[0].x() - held / mass * 1e-5), tolerance() * 5.0);
}

TEST_P(History, IsForgottenWhenTheContactOpens) {
  Scene scene = scratching_scene(law(CoulombLimit::spring));
  scene.particles[0].velocity.z() = 1.0;
  EXPECT_EQ(after(scene, 50).contacts.size(), 1u);
  EXPECT_TRUE(after(scene, 200).contacts.empty());
}

/// Two spheres pressed together along x that turn about each other, after the spring was loaded.
Scene turning_pair(SpringTurn turn) {
  Scene scene = empty_scene(1.0);
  scene.contacts.set(
      0, 0,
      {LinearNormal{stiffness, Restitution{1.0}, false},
       HistoryFriction{100.0, 1.0, 0.0, CoulombLimit::spring, TorqueArm::radius, turn}, NoCohesion{}});
  scene.particles = {sphere(3, {-0.0495, 0, 0}, {0, -1.0, 0}), sphere(9, {0.0495, 0, 0}, {0, 1.0, 0})};
  scene.run.step = 1e-5;
  return scene;
}

TEST_P(History, TurnsWithThePair) {
  const State state = after(turning_pair(SpringTurn::project_and_rescale), 100);
  const Vec3 n = (state.position[1] - state.position[0]).normalized();
  const Vec3 stretched = state.contacts.at(0).tangential_displacement;
  EXPECT_EQ(state.contacts[0].first, 3);
  EXPECT_EQ(state.contacts[0].second, 9);
  ASSERT_GT(n.y(), 0.015);  // it has turned by 20 mrad
  EXPECT_LE(std::abs(stretched.dot(n)), tolerance() * stretched.norm());
  EXPECT_GT(stretched.y(), 0.0);                                   // of the second relative to the first
  EXPECT_LE(std::abs(stretched.norm() / (2.0 * 1e-3) - 1), 1e-3);  // the slip slows as the pair parts
}

TEST_P(History, ProjectionShortensByTheSquareOfTheTurnAStep) {
  const double kept =
      after(turning_pair(SpringTurn::project_and_rescale), 100).contacts.at(0).tangential_displacement.norm();
  const double cut =
      after(turning_pair(SpringTurn::project), 100).contacts.at(0).tangential_displacement.norm();
  // Each step turns by dθ = 2 m/s · 10 µs/99 mm and shortens what is there by dθ²/2: half of them on average.
  const double turn = 2e-5 / 0.099, expected = 100 * turn * turn / 2 / 2;
  const double rounding = 10 * tolerance();  // 100 steps' roundings at random
  EXPECT_LE(std::abs((1 - cut / kept) - expected), 0.05 * expected + rounding);
}

/// The same oblique, spinning hit, somewhere in a periodic box; both are of one size.
Scene oblique_hit(const Vec3& shift) {
  Scene scene = empty_scene(0.8);
  scene.rotation = true;
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{0.8}, false},
                      law(CoulombLimit::spring_and_dashpot, 0.5), NoCohesion{}});
  const Vec3 apart(0.0385, 0.026, -0.017), approach(-0.5, 0.4, 0.3);
  scene.particles = {sphere(0, shift - apart, -approach), sphere(1, shift + apart, approach)};
  for (Particle& p : scene.particles) p.angular_velocity = {10, -20, 30};
  for (Particle& p : scene.particles)
    for (int axis = 0; axis < 3; ++axis) p.position[axis] -= 2.0 * std::floor((p.position[axis] + 1.0) / 2.0);
  return scene;
}

TEST_P(History, TheTwoSidesOfAContactAreMirrorImagesToTheLastBit) {
  const State state = after(oblique_hit(Vec3::Zero()), 20);
  ASSERT_EQ(state.contacts.size(), 1u);
  EXPECT_EQ(state.velocity[0], Vec3(-state.velocity[1]));
  EXPECT_EQ(state.angular_velocity[0], state.angular_velocity[1]);
  EXPECT_NE(state.angular_velocity[0], Vec3(10, -20, 30));
}

TEST_P(History, GoesOnAcrossAPeriodicFace) {
  const State inside = after(oblique_hit(Vec3::Zero()), 20), across = after(oblique_hit({1, 1, 1}), 20);
  ASSERT_EQ(across.contacts.size(), 1u);
  const Vec3 expected = inside.contacts[0].tangential_displacement;
  // Positions near 1 m are rounded to 2^-53 m in double, 2^-54 of the box in single.
  EXPECT_LE((across.contacts[0].tangential_displacement - expected).norm(),
            tolerance() * expected.norm() + 1e-14);
  EXPECT_LE((across.angular_velocity[1] - inside.angular_velocity[1]).norm(), tolerance() * 40 + 1e-10);
}

/// A bound pair drifts at 30 m/s through the box, so that it is listed anew and crosses the face on the way.
TEST_P(History, OutlivesRebuildsAndTheCrossingItself) {
  Scene scene = turning_pair(SpringTurn::project_and_rescale);
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  scene.contacts.set(
      0, 0, {LinearNormal{stiffness, Restitution{1.0}, false}, law(CoulombLimit::spring), NoCohesion{}});
  const State still = after(scene, 200);
  for (Particle& p : scene.particles) p.velocity.z() += 30.0, p.position.z() += 0.97;
  const State moving = after(scene, 200);
  ASSERT_EQ(moving.contacts.size(), 1u);
  EXPECT_LT(moving.position[0].z(), 0.0);
  const Vec3 expected = still.contacts[0].tangential_displacement;
  // Slips are differences of velocities near 30 m/s.
  EXPECT_LE((moving.contacts[0].tangential_displacement - expected).norm(),
            tolerance() * 30.0 * 200 * scene.run.step);
  EXPECT_GT(expected.norm(), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Ways, History,
                         ::testing::Combine(::testing::ValuesIn(every_precision),
                                            ::testing::Values(Path::small, Path::zoned)),
                         [](const ::testing::TestParamInfo<Way>& param) {
                           return std::string(name_of(std::get<0>(param.param))) +
                                  (std::get<1>(param.param) == Path::small ? "_small" : "_zoned");
                         });

}  // namespace
}  // namespace grainproof::opencl::testing
