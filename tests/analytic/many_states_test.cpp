// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "tests/analytic/brute_force.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

constexpr double g = 9.81;

std::string why(const char* form, const Scene& scene) {
  return make_closed_form(form)->supports(scene, {}).because;
}

/// The two spheres of MFiX-DEM's third case, the upper half as dense.
Scene stack() {
  Scene scene = glass_scene();
  scene.materials = {{"heavy", 20000.0, {}}, {"light", 10000.0, {}}};
  scene.contacts = ContactTable(2);
  const ContactLaws laws{LinearNormal{1e3, Restitution{0.8}}};
  for (const auto& [a, b] : {std::pair{0u, 0u}, {0u, 1u}, {1u, 1u}}) scene.contacts.set(a, b, laws);
  scene.gravity = ConstantGravity{{0, 0, -g}};
  scene.walls = {{"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}, Still{}},
                 {"lid", 0, Plane{{0, 0, 1.8e-3}, -Vec3::UnitZ()}, Still{}}};
  add_sphere(scene, {0, 0, 0.45e-3}, Vec3::Zero(), false, 1e-3);
  add_sphere(scene, {0, 0, 1.35e-3}, Vec3::Zero(), false, 1e-3);
  scene.particles[1].material = 1;
  scene.run.end = 5e-3;
  scene.run.sample_times = {0.0, 3e-4, 1e-3, 5e-3};
  return scene;
}

TEST(Stacked, AgreesWithAnIntegration) {
  const Scene scene = stack();
  ASSERT_EQ(why("stacked", scene), "");
  const long double m1 = sphere_mass(20000.0, 1e-3), m2 = sphere_mass(10000.0, 1e-3);
  const LinearNormal law{1e3, Restitution{0.8}};
  const long double wall_1 = damping(law, static_cast<double>(m1)),
                    wall_2 = damping(law, static_cast<double>(m2)),
                    pair = damping(law, static_cast<double>(m1 * m2 / (m1 + m2)));
  const auto rates = [&](long double, const std::array<long double, 4>& y) {
    const long double floor = 1e3L * (5e-4L - y[0]) - wall_1 * y[2];
    const long double lid = 1e3L * (y[1] + 5e-4L - 1.8e-3L) + wall_2 * y[3];
    const long double middle = 1e3L * (1e-3L - y[1] + y[0]) - pair * (y[3] - y[2]);
    return std::array<long double, 4>{y[2], y[3], (floor - middle) / m1 - g, (middle - lid) / m2 - g};
  };
  const Observations seen = make_closed_form("stacked")->observe(scene, {});
  for (const Frame& frame : seen.frames) {
    const auto exact = integrated<4>({0.45e-3L, 1.35e-3L, 0.0L, 0.0L}, frame.time, 20000, rates);
    for (const std::size_t i : {0u, 1u}) {
      // Sizes of 1e-3 m and speeds of 0.3 m/s, times the rounding of an exponential over 60 radians.
      EXPECT_NEAR(frame.position[i].z(), static_cast<double>(exact[i]), 1e-16);
      EXPECT_NEAR(frame.velocity[i].z(), static_cast<double>(exact[i + 2]), 1e-12);
    }
  }
}

TEST(Stacked, IsRefusedOnceABodyComesLoose) {
  Scene scene = stack();
  std::get<Plane>(scene.walls[1].shape).point.z() = 2.2e-3;
  EXPECT_NE(why("stacked", scene).find("pressed"), std::string::npos);
  scene = stack();
  scene.particles[0].velocity.x() = 0.1;
  EXPECT_NE(why("stacked", scene).find("along"), std::string::npos);
}

constexpr double k_t = 2e4, mu = 0.5, radius = 0.05, speed = 0.4;

Scene rolling_scene(const RollingLaw& rolling) {
  Scene scene = glass_scene();
  scene.rotation = true;
  scene.contacts.set(
      0, 0,
      ContactLaws{LinearNormal{1e5, Restitution{0.8}}, HistoryFriction{mu, k_t, 0.2}, NoCohesion{}, rolling});
  scene.gravity = ConstantGravity{{0, 0, -g}};
  add_floor(scene);
  const double rest = sphere_mass(2000.0, 0.1) * g / 1e5;
  add_sphere(scene, {0, 0, radius - rest}, {speed, 0, 0});
  scene.particles[0].angular_velocity = {0, speed / radius, 0};
  scene.run.end = 0.5;
  scene.run.sample_times = {0.0, 0.01, 0.1, 0.5};
  return scene;
}

/// States: path, velocity, spin about y, tangential spring, resisting torque.
using Rolling = std::array<long double, 5>;

TEST(RollingResistance, OfConstantTorqueAgreesWithAnIntegration) {
  const double c = 0.05;
  const Scene scene = rolling_scene(ConstantTorqueRolling{c});
  ASSERT_EQ(why("rolling_resistance", scene), "");
  const long double m = sphere_mass(2000.0, 0.1), inertia = 0.4L * m * radius * radius;
  const long double eta = 0.2 * damping({1e5, Restitution{0.8}}, static_cast<double>(m));
  const auto rates = [&](long double, const Rolling& y) {
    const long double slip = y[1] - radius * y[2], friction = -k_t * y[3] - eta * slip;
    return Rolling{y[1], friction / m, (-radius * friction - c * radius * m * g) / inertia, slip, 0.0L};
  };
  const Observations seen = make_closed_form("rolling_resistance")->observe(scene, {});
  for (const Frame& frame : seen.frames) {
    const auto exact = integrated<5>({0.0L, speed, speed / radius, 0.0L, 0.0L}, frame.time, 40000, rates);
    EXPECT_NEAR(frame.position[0].x(), static_cast<double>(exact[0]), 1e-12);
    EXPECT_NEAR(frame.velocity[0].x(), static_cast<double>(exact[1]), 1e-11);
    EXPECT_NEAR(frame.angular_velocity[0].y(), static_cast<double>(exact[2]), 2e-10);
  }
  // Rolling slows down by 5/7 of coefficient times g, but for what is left of the vibration.
  const double lost = seen.frames[2].velocity[0].x() - seen.frames[3].velocity[0].x();
  EXPECT_NEAR(lost / 0.4 / (5.0 / 7.0 * c * g), 1.0, 3e-3);
}

TEST(RollingResistance, OfConstantTorqueIsRefusedOnceTheSphereStops) {
  Scene scene = rolling_scene(ConstantTorqueRolling{0.05});
  scene.run.end = 2.0;
  EXPECT_NE(why("rolling_resistance", scene).find("stops"), std::string::npos);
  scene = rolling_scene(ConstantTorqueRolling{0.9});
  EXPECT_NE(why("rolling_resistance", scene).find("limit"), std::string::npos);
  EXPECT_NE(why("rolling", rolling_scene(SpringRolling{0.1})).find("resisted"), std::string::npos);
}

/// The spring against rolling loads, slips at its limit, and swings about rest.
TEST(RollingResistance, OnASpringIsWhatTheLawStepByStepConvergesTo) {
  const double c = 0.2;
  Scene scene = rolling_scene(SpringRolling{c});
  ASSERT_EQ(why("rolling_resistance", scene), "");
  const Observations seen = make_closed_form("rolling_resistance")->observe(scene, {});
  const double m = sphere_mass(2000.0, 0.1), inertia = 0.4 * m * radius * radius;
  const double eta = 0.2 * damping({1e5, Restitution{0.8}}, m), limit = c * radius * m * g;
  double worst[2]{};
  bool slipped = false, back = false;
  for (const int halved : {0, 1}) {
    const int steps = 40000 << halved;
    double x = 0.0, v = speed, w = speed / radius, spring = 0.0, torque = 0.0, time = 0.0;
    for (std::size_t n = 1; n < seen.frames.size(); ++n) {
      const Frame& frame = seen.frames[n];
      const double h = (frame.time - time) / steps;
      for (int i = 0; i < steps; ++i) {
        spring += (v - radius * w) * h;
        torque += k_t * radius * radius * w * h;
        slipped = slipped || std::abs(torque) > limit;
        torque = std::clamp(torque, -limit, limit);
        const double friction = -k_t * spring - eta * (v - radius * w);
        v += h * friction / m;
        w += h * (-radius * friction - torque) / inertia;
        back = back || w < 0.0;
        x += h * v;
      }
      time = frame.time;
      worst[halved] = std::max({worst[halved], std::abs(frame.velocity[0].x() - v),
                                std::abs(frame.angular_velocity[0].y() - w) * radius,
                                10.0 * std::abs(frame.position[0].x() - x)});
    }
  }
  EXPECT_TRUE(slipped && back);
  EXPECT_LE(worst[1], 1e-3);  // of 0.4 m/s, in first-order steps of 5e-6 s
  EXPECT_LE(worst[1], 0.6 * worst[0]);
}

TEST(FreeFlight, TurnsABodyAboutASteadyAxis) {
  Scene scene = glass_scene();
  scene.rotation = true;
  scene.orientation = OrientationUpdate::exponential;
  add_sphere(scene, Vec3::Zero(), Vec3::Zero());
  scene.particles[0].angular_velocity = {0.0, 300.0, 400.0};
  const Observations seen = make_closed_form("free_fall")->observe(scene, {});
  const Quaternion turned = seen.frames[1].orientation.at(0);  // after 5 rad about (0, 0.6, 0.8)
  EXPECT_NEAR(turned.w(), std::cos(2.5), 1e-15);
  EXPECT_NEAR(turned.y(), 0.6 * std::sin(2.5), 1e-15);
  EXPECT_NEAR(turned.z(), 0.8 * std::sin(2.5), 1e-15);
}

TEST(PeriodicDomain, IsNoMatterWhereNothingReachesAFace) {
  Scene scene = glass_scene();
  scene.domain = {Vec3::Constant(-0.5), Vec3::Constant(0.5)};
  scene.domain.boundary[0] = Boundary::periodic;
  add_sphere(scene, {-0.06, 0.0, 0.0}, {1.0, 0.0, 0.0});
  add_sphere(scene, {0.06, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  EXPECT_EQ(why("normal_collision", scene), "");
  scene.run.end = 0.6;  // they part again, at 0.8 of their speed
  EXPECT_NE(why("normal_collision", scene).find("reaches one of its faces"), std::string::npos);
  scene.domain.boundary = {Boundary::open, Boundary::periodic, Boundary::open};
  EXPECT_EQ(why("normal_collision", scene), "");
}

Scene gas(double restitution) {
  Scene scene = glass_scene({1e5, Restitution{restitution}});
  scene.domain = {
      Vec3::Zero(), Vec3::Constant(1.0), {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
  for (int i = 0; i < 125; ++i) {
    const Vec3 place(i % 5, i / 5 % 5, i / 25);
    add_sphere(scene, (place.array() + 0.5).matrix() / 5.0, {i % 2 ? 0.3 : -0.3, 0.4, i % 3 - 1.0}, false,
               0.02);
  }
  return scene;
}

TEST(Haff, CoolsByTheKineticTheoryOfDiluteGases) {
  const double e = 0.7;
  const Scene scene = gas(e);
  ASSERT_EQ(why("haff", scene), "");
  const Observations seen = make_closed_form("haff")->observe(scene, {});
  Vec3 drift = Vec3::Zero();
  double temperature = 0.0;
  for (const Particle& particle : scene.particles) drift += particle.velocity / 125.0;
  for (const Particle& particle : scene.particles)
    temperature += (particle.velocity - drift).squaredNorm() / 375.0;
  // 1/τ = (2/3)(1 − e²) sqrt(π T) n d² g(d), g by Carnahan and Starling.
  const double fraction = 125.0 * M_PI / 6.0 * 8e-6;
  const double rate = 2.0 / 3.0 * (1.0 - e * e) * std::sqrt(M_PI * temperature) * 125.0 * 4e-4 *
                      (1.0 - fraction / 2.0) / std::pow(1.0 - fraction, 3);
  EXPECT_NEAR(seen.scalars.at("cooling_time") * rate, 1.0, 1e-14);
  const Vec3 left = seen.frames.back().velocity[7] - drift;
  EXPECT_NEAR(left.norm() / (scene.particles[7].velocity - drift).norm(), 1.0 / (1.0 + rate * 0.02), 1e-14);
  EXPECT_TRUE(std::isnan(seen.frames.back().position[7].x()));
}

TEST(Haff, IsRefusedForOtherGases) {
  Scene walled = gas(0.7);
  add_floor(walled);
  EXPECT_NE(why("haff", walled).find("walls"), std::string::npos);
  Scene mixed = gas(0.7);
  mixed.particles[3].diameter = 0.03;
  EXPECT_NE(why("haff", mixed).find("alike"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::analytic
