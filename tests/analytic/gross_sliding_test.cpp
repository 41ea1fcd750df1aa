// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "tests/analytic/turning_world.hpp"

namespace grainproof::analytic {
namespace {

using namespace turning;

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
    const bool turns = !world.pulling && world.push(world.stepped(s, h)) < 0;  // |F_n| has a corner there
    if (turns) h = halved(h, [&](const Real& middle) { return world.push(world.stepped(s, middle)) < 0; });
    s = world.stepped(s, h);
    world.pulling = world.pulling || turns;
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

}  // namespace
}  // namespace grainproof::analytic
