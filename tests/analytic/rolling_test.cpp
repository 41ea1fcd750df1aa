// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "tests/analytic/turning_world.hpp"

namespace grainproof::analytic {
namespace {

using namespace turning;

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

World springy_world(double k_t) {
  World world;
  world.gravity = Real(9.81);
  world.stiffness = 1e5;
  world.spring = k_t;
  world.sliding = false;
  return world;
}

/// Through the three pieces of rotation.8, joined where the spring reaches its limit and the slip ends.
TEST(Rolling, OnASpringAgreesWithHighPrecisionIntegration) {
  const double k_t = 2e3;
  const Scene scene = rolling_scene(HistoryFriction{mu, k_t, 0.0}, {4.0, -10.0, 3.0});
  const auto form = make_closed_form("rolling");
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  World world = springy_world(k_t);
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
      const bool joint = joints < 2 && passed(world.stepped(s, h));
      if (joint) h = halved(h, [&](const Real& middle) { return passed(world.stepped(s, middle)); });
      s = world.stepped(s, h);
      if (joint) {
        world.sliding = ++joints == 1;
        s.spring = limit / world.spring * direction;
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
