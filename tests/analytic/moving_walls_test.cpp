// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "tests/analytic/brute_force.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

constexpr double g = 9.81, mu = 0.5;

Observations seen_by(const char* form, const Scene& scene) {
  const auto engine = make_closed_form(form);
  const Support support = engine->supports(scene, {});
  if (!support) throw std::runtime_error(std::string(form) + ": " + support.because);
  return engine->observe(scene, {});
}

std::string why(const char* form, const Scene& scene) {
  return make_closed_form(form)->supports(scene, {}).because;
}

/// What happens on a wall that moves evenly is what happens on one at rest, seen from a moving place.
void expect_the_same_seen_from(const Vec3& velocity, const char* form, const Scene& still) {
  Scene moving = still;
  moving.walls[0].motion = Translating{velocity};
  moving.particles[0].velocity += velocity;
  const Observations a = seen_by(form, still), b = seen_by(form, moving);
  for (std::size_t n = 0; n < a.frames.size(); ++n) {
    const Vec3 there = a.frames[n].position[0] + a.frames[n].time * velocity;
    // Positions of 0.1 m and velocities of some m/s carry 1e-16 of that; a contact amplifies it by 1/t_c.
    EXPECT_LE((b.frames[n].position[0] - there).norm(), 2e-15) << form;
    EXPECT_LE((b.frames[n].velocity[0] - a.frames[n].velocity[0] - velocity).norm(), 1e-12) << form;
  }
}

Scene floor_scene(const FrictionLaw& friction, double gap, const Vec3& velocity) {
  Scene scene = glass_scene();
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{1e5, Restitution{0.8}}, friction});
  add_floor(scene);
  add_sphere(scene, {0.0, 0.0, 0.05 + gap}, velocity);
  return scene;
}

double resting_gap() {
  return -sphere_mass(2000.0, 0.1) * g / 1e5;
}

TEST(TranslatingWall, IsAWallAtRestSeenFromAMovingPlace) {
  const Vec3 along(0.7, -0.4, 0.0), oblique(0.7, -0.4, 0.9);
  expect_the_same_seen_from(oblique, "normal_collision", floor_scene(Frictionless{}, 1e-3, {0, 0, -1}));
  expect_the_same_seen_from(oblique, "oblique_collision",
                            floor_scene(DynamicFriction{0.3}, 1e-3, {3, 0, -1}));
  Scene rest = floor_scene(DynamicFriction{mu}, resting_gap(), {1, 0, 0});
  rest.gravity = ConstantGravity{{0, 0, -g}};
  expect_the_same_seen_from(along, "sliding", rest);
  rest.rotation = true;
  expect_the_same_seen_from(along, "rolling", rest);
}

TEST(TranslatingWall, DragsASphereAlongUpToItsSpeed) {
  Scene scene = floor_scene(DynamicFriction{mu}, resting_gap(), Vec3::Zero());
  scene.gravity = ConstantGravity{{0, 0, -g}};
  scene.walls[0].motion = Translating{{0.2, 0.0, 0.0}};
  const double dragged = 0.2 / (mu * g);
  scene.run.sample_times = {0.0, 0.5 * dragged, 2.0 * dragged};
  const Observations seen = seen_by("sliding", scene);
  EXPECT_NEAR(seen.frames[1].velocity[0].x(), 0.1, 1e-15);
  EXPECT_NEAR(seen.frames[2].velocity[0].x(), 0.2, 1e-15);
}

TEST(VibratingWall, ShakesASphereAsAnIntegrationDoes) {
  Scene scene = glass_scene();
  scene.gravity = ConstantGravity{{0, 0, -g}};
  add_floor(scene);
  const Vibrating motion{{0.0, 0.0, 2e-4}, 20.0, 0.4};
  scene.walls[0].motion = motion;
  add_sphere(scene, {0.0, 0.0, 0.05 + resting_gap()}, Vec3::Zero());
  scene.run.sample_times = {0.0, 0.031, 0.1};
  scene.run.end = 0.1;
  const double mass = sphere_mass(2000.0, 0.1), eta = damping({1e5, Restitution{0.8}}, mass);
  const auto rates = [&](long double t, const std::array<long double, 2>& y) {
    const long double turn = 2 * std::numbers::pi_v<long double> * motion.frequency;
    const long double shift =
        motion.amplitude.z() * (std::sin(turn * t + motion.phase) - std::sin(motion.phase));
    const long double speed = motion.amplitude.z() * turn * std::cos(turn * t + motion.phase);
    const long double overlap = 0.05L + shift - y[0];
    return std::array<long double, 2>{y[1], (1e5L * overlap - eta * (y[1] - speed)) / mass - g};
  };
  const Observations seen = seen_by("shaken", scene);
  for (const Frame& frame : seen.frames) {
    const auto exact = integrated<2>({scene.particles[0].position.z(), 0.0L}, frame.time, 20000, rates);
    EXPECT_NEAR(frame.position[0].z(), static_cast<double>(exact[0]), 1e-13);
    EXPECT_NEAR(frame.velocity[0].z(), static_cast<double>(exact[1]), 1e-11);
  }
  scene.walls[0].motion = Vibrating{{0.0, 0.0, 2e-3}, 20.0, 0.4};  // 3.2 g
  EXPECT_NE(why("shaken", scene).find("does not stay"), std::string::npos);
}

Scene drum_scene(double rate) {
  Scene scene = glass_scene();
  scene.rotation = true;
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{1e5, Restitution{0.8}}, DynamicFriction{mu}});
  scene.gravity = ConstantGravity{{0, -g, 0}};
  scene.walls.push_back(
      {"drum", 0, Cylinder{Vec3::Zero(), Vec3::UnitZ(), 0.3, Cylinder::Side::inside}, Rotating{rate}});
  const double angle = std::copysign(std::atan(mu), rate);
  const double overlap = sphere_mass(2000.0, 0.1) * g * std::cos(angle) / 1e5;
  add_sphere(scene, (0.25 + overlap) * Vec3(std::sin(angle), -std::cos(angle), 0.0), Vec3::Zero());
  return scene;
}

Scene turntable_scene(double rate) {
  Scene scene = glass_scene();
  scene.rotation = true;
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{1e5, Restitution{0.8}}, HistoryFriction{mu, 1e5, 0.3}});
  scene.gravity = ConstantGravity{{0, 0, -g}};
  scene.walls.push_back({"table", 0, Plane{{0.02, 0.0, 0.0}, Vec3::UnitZ()}, Rotating{rate}});
  add_sphere(scene, {0.22, 0.0, 0.05 + resting_gap()}, {0.1, 0.3, 0.0});
  // No slip: v - r w x n is what the table does under the sphere, (0, 0.2 rate).
  const Vec3 surface = scene.particles[0].velocity - Vec3(0.0, 0.2 * rate, 0.0);
  scene.particles[0].angular_velocity = Vec3::UnitZ().cross(surface) / 0.05 + Vec3(0.0, 0.0, 7.0);
  scene.run.end = 1.0;
  scene.run.sample_times = {0.0, 0.25, 1.0};
  return scene;
}

TEST(Turntable, AgreesWithAnIntegration) {
  const double rate = 3.0;
  const Scene scene = turntable_scene(rate);
  const long double mass = sphere_mass(2000.0, 0.1);
  const long double eta = 0.3 * damping({1e5, Restitution{0.8}}, static_cast<double>(mass));
  // x, y, u, v, spin about x, about y, spring along x, along y.
  const auto rates = [&](long double, const std::array<long double, 8>& y) {
    const long double slip_x = y[2] - 0.05L * y[5] + rate * y[1];
    const long double slip_y = y[3] + 0.05L * y[4] - rate * (y[0] - 0.02L);
    const long double fx = -1e5L * y[6] - eta * slip_x, fy = -1e5L * y[7] - eta * slip_y;
    const long double inertia = 0.4L * mass * 0.0025L;
    return std::array<long double, 8>{
        y[2], y[3], fx / mass, fy / mass, 0.05L * fy / inertia, -0.05L * fx / inertia, slip_x, slip_y};
  };
  const Particle& p = scene.particles[0];
  for (const Frame& frame : seen_by("turntable", scene).frames) {
    const auto exact = integrated<8>({p.position.x(), p.position.y(), p.velocity.x(), p.velocity.y(),
                                      p.angular_velocity.x(), p.angular_velocity.y(), 0.0L, 0.0L},
                                     frame.time, 60000, rates);
    for (int axis : {0, 1}) {
      EXPECT_NEAR(frame.position[0][axis], static_cast<double>(exact[axis]), 1e-11);
      EXPECT_NEAR(frame.velocity[0][axis], static_cast<double>(exact[axis + 2]), 1e-10);
      EXPECT_NEAR(frame.angular_velocity[0][axis], static_cast<double>(exact[axis + 4]), 1e-9);
    }
    EXPECT_EQ(frame.angular_velocity[0].z(), 7.0);
  }
}

/// On a stiff spring the sphere circles at 2/7 of the table's rate, whatever its size: walls.9.
TEST(Turntable, MakesARollingSphereCircleAtTwoSeventhsOfItsRate) {
  const Scene scene = turntable_scene(3.0);
  const Frame last = seen_by("turntable", scene).frames.back();
  const Vec3 turned = Eigen::AngleAxisd(2.0 / 7.0 * 3.0, Vec3::UnitZ()) * scene.particles[0].velocity;
  EXPECT_LE((last.velocity[0] - turned).norm(), 1e-3 * turned.norm());
  EXPECT_GT(std::abs(last.velocity[0].y()), 0.1);
}

TEST(Turntable, IsRefusedWhereItSlides) {
  Scene scene = turntable_scene(3.0);
  scene.particles[0].angular_velocity = Vec3::Zero();
  EXPECT_NE(why("turntable", scene).find("limit"), std::string::npos);
  scene.rotation = false;
  EXPECT_NE(why("turntable", scene).find("nothing turns"), std::string::npos);
}

TEST(Drum, HoldsASphereAtTheAngleOfFrictionAndSpinsItUp) {
  for (const double rate : {6.0, -6.0}) {
    const Scene scene = drum_scene(rate);
    const Observations seen = seen_by("drum", scene);
    EXPECT_EQ(seen.frames.back().position[0], scene.particles[0].position);
    const double spin = 2.5 * mu * g * std::cos(std::atan(mu)) / 0.05 * 0.02;
    EXPECT_NEAR(seen.frames.back().angular_velocity[0].z(), std::copysign(spin, rate), 1e-12);
  }
}

TEST(Drum, IsRefusedOnTheOtherSideAndOnceItsSurfaceIsAsFast) {
  Scene scene = drum_scene(6.0);
  scene.particles[0].position.x() *= -1.0;
  EXPECT_NE(why("drum", scene).find("balance"), std::string::npos);
  scene = drum_scene(6.0);
  scene.run.end = 1.0;
  EXPECT_NE(why("drum", scene).find("as fast"), std::string::npos);
}

/// Along a radius a cylinder is a plane.
TEST(Cylinder, IsAPlaneToASphereThatMovesAlongItsRadius) {
  const Scene plane = floor_scene(Frictionless{}, 1e-3, {0, 0, -1});
  for (const auto side : {Cylinder::Side::inside, Cylinder::Side::outside}) {
    Scene round = plane;
    const double centre = side == Cylinder::Side::inside ? 0.3 : -0.3;
    round.walls[0].shape = Cylinder{{0, 0.7, centre}, Vec3::UnitY(), 0.3, side};
    const Observations a = seen_by("normal_collision", plane), b = seen_by("normal_collision", round);
    for (std::size_t n = 0; n < a.frames.size(); ++n) {
      EXPECT_LE((a.frames[n].position[0] - b.frames[n].position[0]).norm(), 1e-15);
      EXPECT_LE((a.frames[n].velocity[0] - b.frames[n].velocity[0]).norm(), 1e-12);
    }
    round.particles[0].velocity.x() = 0.1;
    EXPECT_NE(why("normal_collision", round).find("straight towards"), std::string::npos);
  }
}

TEST(OtherForms, SayNoToWallsThatTurnOrVibrateAndToCentresInTheSolid) {
  Scene scene = floor_scene(Frictionless{}, 1e-3, {0, 0, -1});
  scene.walls[0].motion = Vibrating{{0, 0, 1e-3}, 10.0, 0.0};
  EXPECT_NE(why("normal_collision", scene).find("vibrates"), std::string::npos);
  scene.walls[0].motion = Rotating{1.0};
  EXPECT_NE(why("normal_collision", scene).find("turns"), std::string::npos);
  EXPECT_NE(why("free_fall", scene).find("might meet"), std::string::npos);
  scene.walls[0] = {"drum", 0, Cylinder{Vec3::Zero(), Vec3::UnitX(), 0.3, Cylinder::Side::outside}, Still{}};
  EXPECT_NE(why("normal_collision", scene).find("not in front"), std::string::npos);
}

TEST(FreeFall, PassesACylinderThatItStaysClearOf) {
  Scene scene = glass_scene();
  add_sphere(scene, {0.0, 0.0, 0.05}, {1.0, 0.0, 0.0});
  scene.run.end = 0.1;
  const auto with = [&](double radius, Cylinder::Side side, const Vec3& point) {
    scene.walls = {{"drum", 0, Cylinder{point, Vec3::UnitZ(), radius, side}, Still{}}};
    return why("free_fall", scene);
  };
  EXPECT_EQ(with(0.16, Cylinder::Side::inside, Vec3::Zero()), "");
  EXPECT_NE(with(0.14, Cylinder::Side::inside, Vec3::Zero()), "");
  EXPECT_EQ(with(0.14, Cylinder::Side::outside, {0.3, 0.0, 0.0}), "");
  EXPECT_NE(with(0.16, Cylinder::Side::outside, {0.3, 0.0, 0.0}), "");
}

}  // namespace
}  // namespace grainproof::analytic
