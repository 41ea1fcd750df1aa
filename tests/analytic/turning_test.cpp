// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

using Real = boost::multiprecision::cpp_bin_float_quad;
using Vector = Eigen::Matrix<Real, 3, 1>;

const Vec3 slanted = Vec3(2.0, -3.0, 6.0) / 7.0;
const Vec3 aside = Vec3(6.0, -2.0, -3.0) / 7.0;  // at right angles to `slanted`
constexpr double mu = 0.3;

/// A sphere of diameter 0.1 and density 2000 on a wall through the origin, 3 m/s along it.
Scene on_wall(const ContactLaws& laws, double gap, double inward, const Vec3& spin) {
  Scene scene = glass_scene();
  scene.rotation = true;
  scene.contacts.set(0, 0, laws);
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), slanted}});
  add_sphere(scene, (0.05 + gap) * slanted, 3.0 * aside - inward * slanted);
  scene.particles[0].angular_velocity = spin;
  return scene;
}

/// The wall contact of docs/laws/rotation.md, written a second time, with 34 digits. The spring is kept
/// at its limit while `sliding`.
struct Sphere {
  Vector x, v, w, spring;
};

struct World {
  Real mass = Real(2000) * boost::math::constants::pi<Real>() / 6 / 1000, radius = Real(0.1) / 2;
  Vector normal = slanted.cast<Real>().normalized();
  Real gravity = 0, stiffness = 0, dashpot = 0;  ///< Hertz: K, and η/δ^(1/4)
  bool hertz = false;
  Real spring = 0;  ///< 0: none
  bool sliding = true, pulling = false;
  Vector along = Vector::Zero();  ///< where the slip is to come to an end, its direction

  Real overlap(const Sphere& s) const { return radius - s.x.dot(normal); }
  Vector slip(const Sphere& s) const {
    const Vector u = s.v - radius * s.w.cross(normal);
    return u - u.dot(normal) * normal;
  }
  Real push(const Sphere& s) const {
    const Real d = overlap(s);
    if (!(d > 0)) return 0;
    const Real root = hertz ? sqrt(d) : Real(1);
    return stiffness * d * root - dashpot * (hertz ? Real(sqrt(root)) : Real(1)) * s.v.dot(normal);
  }
  Vector friction(const Sphere& s) const {
    if (!sliding) return -spring * s.spring;
    const Vector u = along.isZero() ? slip(s) : along;
    return Real(mu) * (pulling ? push(s) : Real(-push(s))) / u.norm() * u;
  }
  Sphere rate(const Sphere& s) const {
    const Vector f = friction(s);
    return {s.v, (push(s) / mass - gravity) * normal + f / mass,
            Vector((-radius * normal).cross(f) * (5 / (2 * mass * radius * radius))), slip(s)};
  }
  Sphere stepped(const Sphere& s, const Real& h) const {
    const auto plus = [&](const Real& part, const Sphere& k) {
      return Sphere{s.x + part * k.x, s.v + part * k.v, s.w + part * k.w, s.spring + part * k.spring};
    };
    const auto mean = [&](const Vector Sphere::*of, const Sphere& a, const Sphere& b, const Sphere& c,
                          const Sphere& d) {
      return Vector(s.*of + h / 6 * (a.*of + 2 * b.*of + 2 * c.*of + d.*of));
    };
    const Sphere a = rate(s), b = rate(plus(h / 2, a)), c = rate(plus(h / 2, b)), d = rate(plus(h, c));
    return {mean(&Sphere::x, a, b, c, d), mean(&Sphere::v, a, b, c, d), mean(&Sphere::w, a, b, c, d),
            mean(&Sphere::spring, a, b, c, d)};
  }
};

Sphere start_of(const Scene& scene) {
  const Particle& p = scene.particles[0];
  return {p.position.cast<Real>(), p.velocity.cast<Real>(), p.angular_velocity.cast<Real>(), Vector::Zero()};
}

void expect_near(const Frame& frame, const Sphere& exact, double length, double speed) {
  EXPECT_LE((frame.position[0].cast<Real>() - exact.x).norm(), length) << frame.time;
  EXPECT_LE((frame.velocity[0].cast<Real>() - exact.v).norm(), speed) << frame.time;
  EXPECT_LE((frame.angular_velocity[0].cast<Real>() - exact.w).norm(), 20 * speed) << frame.time;
}

struct Striking {
  std::string label;
  NormalLaw law;
};

class EveryGrossSliding : public testing::TestWithParam<Striking> {};

World world_of(const NormalLaw& law) {
  World world;
  const Real pi = boost::math::constants::pi<Real>();
  const auto* linear = std::get_if<LinearNormal>(&law);
  const Real loss = log(Real(
      std::get<Restitution>(linear ? linear->dissipation : std::get<HertzNormal>(law).dissipation).value));
  const Real beta = -loss / sqrt(loss * loss + pi * pi);
  world.hertz = linear == nullptr;
  if (linear) {
    world.stiffness = linear->stiffness;
    world.dashpot = 2 * beta * sqrt(world.mass * world.stiffness);
    return world;
  }
  const Real tangent = Real(1e8) / (1 - Real(1) / 16) * sqrt(world.radius);  // 2 E* sqrt(R*)
  world.stiffness = 2 * tangent / 3;
  world.dashpot = 2 * beta * sqrt(Real(5) / 6 * world.mass * tangent);
  return world;
}

/// Fourth-order steps of 1/2000 of the contact, finer where the overlap is small.
TEST_P(EveryGrossSliding, AgreesWithHighPrecisionIntegration) {
  const Scene scene = on_wall({GetParam().law, DynamicFriction{mu}}, 0.0, 1.0, {4.0, -10.0, 3.0});
  const auto form = make_closed_form("gross_sliding");
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  World world = world_of(GetParam().law);
  const Real cap = Real(form->observe(scene, {}).scalars.at("contact_duration")) / 2000, least = Real(1e-14);
  Sphere s = start_of(scene);
  const Vector slip = world.slip(s);
  s.x = (world.radius - least) * world.normal;
  Real time = least;
  Request request;
  std::vector<Sphere> states;
  do {
    const Real d = world.overlap(s), own = d / (32 * abs(s.v.dot(world.normal)) + d);
    Real h = own < cap ? own : cap;
    if (!world.pulling && world.push(world.stepped(s, h)) < 0) {  // |F_n| has a corner here
      Real low = 0;
      for (int halving = 0; halving < 100; ++halving) {
        const Real middle = (low + h) / 2;
        (world.push(world.stepped(s, middle)) < 0 ? h : low) = middle;
      }
      s = world.stepped(s, h);
      world.pulling = true;
    } else {
      s = world.stepped(s, h);
    }
    time += h;
    request.times.push_back(static_cast<double>(time));
    states.push_back(s);
  } while (world.overlap(s) > least);
  const Observations seen = form->observe(scene, request);
  for (std::size_t n = 0; n < states.size(); n += 50) {
    Sphere exact = states[n];
    exact.x += least * Vector(3 * aside.cast<Real>());  // the run along the wall before the first step
    expect_near(seen.frames[n], exact, 1e-12, 1e-9);
  }
  EXPECT_NEAR(seen.scalars.at("tangential_velocity_change"),
              static_cast<double>((slip - world.slip(s)).norm()), 1e-8);
}

const Striking strikings[] = {{"LinearElastic", LinearNormal{1e5, Restitution{1.0}}},
                              {"LinearDamped", LinearNormal{1e5, Restitution{0.5}}},
                              {"HertzElastic", HertzNormal{Restitution{1.0}}},
                              {"HertzDamped", HertzNormal{Restitution{0.5}}}};
INSTANTIATE_TEST_SUITE_P(, EveryGrossSliding, testing::ValuesIn(strikings),
                         [](const auto& param) { return param.param.label; });

/// rotation.9 by hand: 7/2 of μ (1 + e) v_n off the slip, 5/2 of it over r onto the spin.
TEST(GrossSliding, TakesSevenHalvesOfTheCoulombImpulseOffTheSlip) {
  for (const NormalLaw& law :
       {NormalLaw{LinearNormal{1e5, Restitution{0.5}, true}}, NormalLaw{HertzNormal{Restitution{1.0}}}}) {
    const double e = std::holds_alternative<HertzNormal>(law) ? 1.0 : 0.5;
    const Scene scene = on_wall({law, DynamicFriction{mu}}, 1e-3, 1.0, Vec3::Zero());
    const Observations seen = make_closed_form("gross_sliding")->observe(scene, {});
    EXPECT_NEAR(seen.scalars.at("tangential_velocity_change"), 3.5 * mu * (1 + e), 1e-12);
    const Frame& last = seen.frames.back();
    EXPECT_NEAR(last.velocity[0].dot(aside), 3.0 - mu * (1 + e), 1e-12);
    EXPECT_NEAR(last.angular_velocity[0].dot(slanted.cross(aside)), 2.5 / 0.05 * mu * (1 + e), 1e-11);
  }
}

TEST(GrossSliding, OfASpringIsThatOfDynamicFrictionAndRefusedWhereItSticks) {
  const auto form = make_closed_form("gross_sliding");
  const auto scene_of = [](const NormalLaw& law, double damping, TorqueArm arm, const Vec3& spin) {
    HistoryFriction friction{mu, 4e4, damping};
    friction.arm = arm;
    return on_wall({law, friction}, 1e-3, 1.0, spin);
  };
  const NormalLaw elastic = LinearNormal{1e5, Restitution{1.0}}, damped = LinearNormal{1e5, Restitution{0.8}};
  const auto why = [&](const NormalLaw& law, TorqueArm arm, const Vec3& spin) {
    return form->supports(scene_of(law, 0.0, arm, spin), {}).because;
  };
  const Scene scene = scene_of(elastic, 0.5, TorqueArm::radius, Vec3::Zero());
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  EXPECT_NEAR(form->observe(scene, {}).scalars.at("tangential_velocity_change"), 7 * mu, 1e-12);
  EXPECT_NE(why(damped, TorqueArm::radius, Vec3::Zero()).find("sticks at first"), std::string::npos);
  EXPECT_NE(why(elastic, TorqueArm::overlap, Vec3::Zero()).find("arm"), std::string::npos);
  const Vec3 with_the_slip = slanted.cross(aside) * 2.0 / 0.05;
  EXPECT_NE(why(elastic, TorqueArm::radius, with_the_slip).find("stops slipping"), std::string::npos);
  const HistoryFriction soft{mu, 1e3, 0.0};
  EXPECT_NE(form->supports(on_wall({elastic, soft}, 1e-3, 1.0, Vec3::Zero()), {}).because.find("slower"),
            std::string::npos);
}

Scene rolling_scene(const FrictionLaw& friction, const Vec3& spin = Vec3::Zero()) {
  const double rest = sphere_mass(2000.0, 0.1) * 9.81 / 1e5;
  Scene scene = on_wall({LinearNormal{1e5, Restitution{0.8}}, friction}, -rest, 0.0, spin);
  scene.gravity = ConstantGravity{-9.81 * slanted};
  return scene;
}

TEST(Rolling, TakesFiveSeventhsOfTheSpeedInTwoSeventhsOfTheStoppingTime) {
  const Scene scene = rolling_scene(DynamicFriction{mu});
  const auto form = make_closed_form("rolling");
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  const double time = 2.0 * 3.0 / (7.0 * mu * 9.81);
  Request request;
  request.times = {0.5 * time, 2.0 * time};
  const Observations seen = form->observe(scene, request);
  EXPECT_NEAR(seen.scalars.at("rolling_time"), time, 1e-15);
  EXPECT_NEAR(seen.scalars.at("rolling_speed"), 15.0 / 7.0, 1e-15);
  EXPECT_NEAR(seen.frames[0].velocity[0].dot(aside), 3.0 - 0.5 * time * mu * 9.81, 1e-14);
  EXPECT_NEAR(seen.frames[1].velocity[0].dot(aside), 15.0 / 7.0, 1e-14);
  EXPECT_NEAR(seen.frames[1].angular_velocity[0].dot(slanted.cross(aside)), 15.0 / 7.0 / 0.05, 1e-12);
}

/// Through all three pieces of rotation.8, joined where the spring reaches its limit and the slip ends.
TEST(Rolling, OnASpringAgreesWithHighPrecisionIntegration) {
  const double k_t = 2e3;
  const Scene scene = rolling_scene(HistoryFriction{mu, k_t, 0.0}, {4.0, -10.0, 3.0});
  const auto form = make_closed_form("rolling");
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  World world;
  world.gravity = Real(9.81);
  world.stiffness = 1e5;
  world.spring = k_t;
  world.sliding = false;
  const Real limit = Real(mu) * world.mass * world.gravity;
  const Vector direction = world.slip(start_of(scene)).normalized();
  world.along = direction;
  Sphere s = start_of(scene);
  s.x = (world.radius - world.mass * world.gravity / world.stiffness) * world.normal;
  const auto passed = [&](const Sphere& later) {
    return world.sliding ? world.slip(later).dot(direction) <= 0
                         : world.spring * later.spring.norm() >= limit;
  };
  const double end = 3.0 * form->observe(scene, {}).scalars.at("rolling_time");
  const Real step = Real(end) / 12000;
  Request request;
  std::vector<Sphere> states;
  int joints = 0;
  for (int n = 1; n <= 12000; ++n) {
    Real left = step;
    while (left > 0) {
      Real h = left;
      if (joints < 2 && passed(world.stepped(s, h))) {
        Real low = 0;
        for (int halving = 0; halving < 100; ++halving) {
          const Real middle = (low + h) / 2;
          (passed(world.stepped(s, middle)) ? h : low) = middle;
        }
        s = world.stepped(s, h);
        world.sliding = ++joints == 1;
        s.spring = limit / world.spring * direction;
      } else {
        s = world.stepped(s, h);
      }
      left -= h;
    }
    if (n % 120 != 0) continue;
    request.times.push_back(end * n / 12000);
    states.push_back(s);
  }
  EXPECT_EQ(joints, 2);
  const Observations seen = form->observe(scene, request);
  // Fourth-order steps of 1/900 of a vibration.
  for (std::size_t n = 0; n < states.size(); ++n) expect_near(seen.frames[n], states[n], 1e-10, 1e-9);
}

TEST(Rolling, IsRefusedWhereItIsNotExact) {
  const auto why = [](Scene scene) { return make_closed_form("rolling")->supports(scene, {}).because; };
  EXPECT_NE(why(rolling_scene(HistoryFriction{mu, 1e4, 0.5})).find("damped"), std::string::npos);
  EXPECT_NE(why(rolling_scene(StepFriction{mu, 1e4})).find("neither"), std::string::npos);
  Scene still = rolling_scene(DynamicFriction{mu});
  still.rotation = false;
  EXPECT_NE(why(still).find("nothing turns"), std::string::npos);
  EXPECT_FALSE(make_closed_form("sliding")->supports(rolling_scene(DynamicFriction{mu}), {}));
}

TEST(OtherForms, SayNoWhereFrictionMakesBodiesTurnOrTheContactIsHertz) {
  const Scene turning =
      on_wall({LinearNormal{1e5, Restitution{0.8}}, DynamicFriction{mu}}, 0.0, 1.0, Vec3::Zero());
  EXPECT_NE(make_closed_form("oblique_collision")->supports(turning, {}).because.find("turn"),
            std::string::npos);
  Scene straight = turning;
  straight.particles[0].velocity = -slanted;
  EXPECT_TRUE(make_closed_form("normal_collision")->supports(straight, {}));
  straight.particles[0].angular_velocity = {0, 1, 0};
  EXPECT_NE(make_closed_form("normal_collision")->supports(straight, {}).because.find("spins"),
            std::string::npos);
  const Scene hertz = on_wall({HertzNormal{Restitution{0.8}}}, 0.0, 1.0, Vec3::Zero());
  for (const char* form :
       {"normal_collision", "bounce", "settling", "sliding", "oblique_collision", "cohesive_collision"})
    EXPECT_NE(make_closed_form(form)->supports(hertz, {}).because.find("Hertz"), std::string::npos) << form;
}

}  // namespace
}  // namespace grainproof::analytic
