// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cmath>

#include "device_fixture.hpp"
#include "opencl/pair_laws.hpp"
#include "scenes.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double mu = 0.3, g = 9.81, launch = 1.0, radius = diameter / 2;
const double mass = sphere_mass(density, diameter);

Scene rolling_scene(const FrictionLaw& friction, double end) {
  Scene scene = settling_scene(1);
  scene.rotation = true;
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}, false}, friction, NoCohesion{}});
  scene.particles[0].position.z() -= mass * g / stiffness;
  scene.particles[0].velocity = {launch, 0, 0};
  scene.run.step /= 4;
  scene.run.end = end;
  scene.run.sample_times = {0.0, end};
  return scene;
}

class Rotation : public ::testing::TestWithParam<Precision> {
 protected:
  Frame at_end(const Scene& scene) const { return observed(options_for(GetParam()), scene).frames.back(); }
  double tolerance() const { return 32 * roundoff(GetParam()); }
};

const double until_rolling = 2 * launch / (7 * mu * g);

TEST_P(Rotation, ASlidingSphereSpinsUpByFiveHalvesOfWhatItLoses) {
  const Frame seen = at_end(rolling_scene(DynamicFriction{mu}, 0.5 * until_rolling));
  const double steps = 0.5 * until_rolling / rolling_scene(DynamicFriction{mu}, 1).run.step;
  const double lost = mu * g * seen.time;
  // Double rounds two kicks a step; single keeps what rounding leaves out of a velocity, but not of a force.
  const double rounding = tolerance() + 4 * steps * double_roundoff;
  EXPECT_LE(std::abs(seen.velocity[0].x() - (launch - lost)), rounding);
  EXPECT_LE(std::abs(seen.angular_velocity[0].y() * radius - 2.5 * lost), 2.5 * rounding);
  EXPECT_EQ(seen.angular_velocity[0].x(), 0.0);
}

TEST_P(Rotation, SlidingTurnsIntoRollingAtFiveSevenths) {
  for (const CoulombLimit limit : {CoulombLimit::spring, CoulombLimit::spring_and_dashpot}) {
    const HistoryFriction friction{mu, 8e4, 1.0, limit, TorqueArm::radius, SpringTurn::project_and_rescale};
    const Frame seen = at_end(rolling_scene(friction, 6 * until_rolling));
    // The spring's last swing is damped away; the roll is free of slip but for what rounding feeds it.
    EXPECT_LE(std::abs(seen.velocity[0].x() - 5.0 / 7.0), 1e-3);
    EXPECT_LE(std::abs(seen.angular_velocity[0].y() * radius - seen.velocity[0].x()), 1e-3);
  }
}

TEST_P(Rotation, SlidingLastsTwoSeventhsOfSpeedOverDeceleration) {
  for (const double part : {0.95, 1.05}) {
    const HistoryFriction friction{
        mu, 1e6, 1.0, CoulombLimit::spring, TorqueArm::radius, SpringTurn::project};
    const Frame seen = at_end(rolling_scene(friction, part * until_rolling));
    const double slip = seen.velocity[0].x() - radius * seen.angular_velocity[0].y();
    const double expected = std::max(0.0, launch - 3.5 * mu * g * seen.time);
    // Until the spring has been stretched to the limit, μ m g/k_t at 1 m/s, friction was half as strong.
    EXPECT_LE(std::abs(slip - expected), 0.5 * 3.5 * mu * g * (mu * mass * g / 1e6) / launch + 1e-2) << part;
  }
}

/// Two spheres that touch along x, the second spinning about z.
Scene spinning_pair(double first, double second, TorqueArm arm) {
  Scene scene = empty_scene(0.8);
  scene.rotation = true;
  scene.contacts.set(
      0, 0,
      {LinearNormal{stiffness, Restitution{0.8}, false},
       HistoryFriction{0.5, 8e4, 0.0, CoulombLimit::spring, arm, SpringTurn::project_and_rescale},
       NoCohesion{}});
  scene.particles = {sphere(0, {-0.03, 0, 0}, {0, 0, 0}, 0.1), sphere(1, {0.043, 0, 0}, {0, 0, 0}, 0.05)};
  scene.particles[0].angular_velocity = {0, 0, first};
  scene.particles[1].angular_velocity = {0, 0, second};
  scene.run.step = 1e-5;
  scene.run.end = 1e-5;
  scene.run.sample_times = {0.0, 1e-5};
  return scene;
}

TEST_P(Rotation, TorquesAndForcesHaveTheSignsOfTwoWheels) {
  const Frame seen = at_end(spinning_pair(0, 100, TorqueArm::radius));
  // The second's surface at the contact moves along −y; friction pushes it along +y and slows it, and turns
  // the first along +y's opposite with the same torque sign: two wheels slow and speed up in opposite senses.
  EXPECT_GT(seen.velocity[1].y(), 0.0);
  EXPECT_LT(seen.velocity[0].y(), 0.0);
  EXPECT_LT(seen.angular_velocity[1].z(), 100.0);
  EXPECT_LT(seen.angular_velocity[0].z(), 0.0);
}

TEST_P(Rotation, TheArmIsTheRadiusOrShortenedByHalfTheOverlap) {
  for (const TorqueArm arm : {TorqueArm::radius, TorqueArm::overlap}) {
    const Scene scene = spinning_pair(0, 100, arm);
    OpenClEngine engine(options_for(GetParam()));
    const auto run = engine.start(scene, {});
    run->advance(1);
    const State state = run->state();
    const double overlap = 0.075 - (state.position[1] - state.position[0]).norm();
    const double length = arm == TorqueArm::radius ? 0.025 : 0.025 - overlap / 2;
    const double stretched = state.contacts.at(0).tangential_displacement.y();
    EXPECT_LE(std::abs(stretched + 100 * length * 1e-5), tolerance() * 100 * length * 1e-5);
    // The force is k_t ζ, and its half kick turns the second by F a/I h/2.
    const double force = 8e4 * 100 * length * 1e-5, inertia = inertia_of(scene.particles[1], scene);
    const double slowed = 100 - run->frame().angular_velocity[1].z();
    EXPECT_LE(std::abs(slowed - force * length / inertia * 0.5e-5), tolerance() * 100);
  }
}

TEST_P(Rotation, AFixedSphereMustNotSpin) {
  Scene scene = spinning_pair(0, 100, TorqueArm::radius);
  scene.particles[1].fixed = true;
  const OpenClEngine engine(options_for(GetParam()));
  EXPECT_NE(engine.supports(scene, {}).because.find("1 is fixed and spins"), std::string::npos);
  scene.particles[1].angular_velocity = Vec3::Zero();
  EXPECT_TRUE(engine.supports(scene, {}));
  scene.particles[0].angular_velocity = {0, 0, 100};
  const Frame seen = at_end(scene);
  EXPECT_EQ(seen.angular_velocity[1], Vec3::Zero());
  EXPECT_LT(seen.angular_velocity[0].z(), 100.0);
}

struct Turning {
  Vec3 total = Vec3::Zero();
  double scale = 0.0;
};

Turning angular_momentum(const Scene& scene, const Frame& frame) {
  Turning l;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Vec3 orbit = mass_of(scene.particles[i], scene) * frame.position[i].cross(frame.velocity[i]);
    const Vec3 spin = inertia_of(scene.particles[i], scene) * frame.angular_velocity[i];
    l.total += orbit + spin;
    l.scale += orbit.norm() + spin.norm();
  }
  return l;
}

TEST_P(Rotation, AngularMomentumOfAFreeGasIsKeptWithArmsThatMeet) {
  Scene scene = varied_scene("turning_liggghts", 4);
  scene.walls.clear();
  scene.gravity = ConstantGravity{Vec3::Zero()};
  scene.domain.boundary = {};
  scene.domain.lower -= Vec3::Constant(1.0);
  scene.domain.upper += Vec3::Constant(1.0);
  const Observations seen = observed(options_for(GetParam()), scene);
  const Turning before = angular_momentum(scene, seen.frames.front());
  const Turning after = angular_momentum(scene, seen.frames.back());
  const double error = (after.total - before.total).norm() / before.scale;
  RecordProperty("relative_error", ::testing::PrintToString(error));
  // As linear momentum: a rounding of the momentum in motion a step, adding up at random.
  EXPECT_LE(error, 2 * std::sqrt(varied_steps) * roundoff(GetParam()));
  EXPECT_GT((seen.frames.back().angular_velocity[7] - seen.frames.front().angular_velocity[7]).norm(), 1e-3);
}

/// What a scene says and the engine cannot do is refused, each with its reason.
TEST_P(Rotation, WhatCannotBeIsRefusedWithItsReason) {
  const OpenClEngine engine(options_for(GetParam()));
  const Scene pair = spinning_pair(0, 100, TorqueArm::radius);
  const auto because = [&](const auto& change) {
    Scene scene = pair;
    change(scene);
    return engine.supports(scene, {}).because;
  };
  const auto says = [](const std::string& answer, const char* text) {
    return answer.find(text) != std::string::npos;
  };
  const Rectangle sheet{{-0.5, -0.5, -0.5}, {0.5, 0.5, -0.5}};
  const Cylinder tube{Vec3::Zero(), Vec3::UnitZ(), 0.04, Cylinder::Side::inside};
  EXPECT_TRUE(engine.supports(pair, {}));
  EXPECT_TRUE(says(because([&](Scene& s) { s.walls = {{"sheet", 0, sheet, Rotating{1.0}}}; }), "rectangle"));
  EXPECT_TRUE(says(because([&](Scene& s) { s.walls = {{"tube", 0, tube}}; }), "does not fit"));
  EXPECT_TRUE(says(because([](Scene& s) {
                     s.remembered = {{0, 7, 0, Vec3::Zero()}};
                   }),
                   "not both are there"));
  EXPECT_TRUE(says(because([](Scene& s) {
                     s.particles[1].position.x() = 0.5;
                     s.remembered = {{0, 1, 0, Vec3(0, 1e-6, 0)}};
                   }),
                   "do not touch"));
  EXPECT_TRUE(says(because([](Scene& s) {
                     s.remembered = {{0, 1, 0, Vec3::Zero(), 0.0, Vec3(1, 0, 0)}};
                   }),
                   "do not keep"));
  EXPECT_TRUE(says(because([](Scene& s) {
                     s.contacts.set(0, 0,
                                    {LinearNormal{stiffness, Restitution{0.8}}, Frictionless{}, NoCohesion{},
                                     SpringRolling{0.1}});
                   }),
                   "friction with history"));
  EXPECT_TRUE(says(because([](Scene& s) {
                     s.rotation = false;
                     s.orientation = OrientationUpdate::exponential;
                   }),
                   "rotation"));
}

GRAINPROOF_IN_EVERY_PRECISION(Rotation);

TEST(Inertia, IsTwoFifthsOfMassTimesRadiusSquared) {
  const Scene scene = head_on_scene(0.8, 64);
  EXPECT_DOUBLE_EQ(inertia_of(scene.particles[0], scene), 0.4 * mass * radius * radius);
}

}  // namespace
}  // namespace grainproof::opencl::testing
