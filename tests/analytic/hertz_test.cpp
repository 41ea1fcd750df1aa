// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/hertz.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "model/errors.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

using Real = boost::multiprecision::cpp_bin_float_quad;

/// hertz.4 along its normal, written a second time and integrated with 34 digits.
struct ExactHertz {
  Real mass, constant, dashpot;  ///< m, K, and η/δ^(1/4)

  /// The overlap and its rate.
  struct At {
    Real overlap, speed;
  };

  At rate(const At& s) const {
    const Real root = sqrt(s.overlap), quarter = sqrt(root);
    return {s.speed, -(constant * s.overlap * root + dashpot * quarter * s.speed) / mass};
  }

  At stepped(const At& s, const Real& h) const {
    // Six stages of fifth order (Butcher).
    const auto plus = [&](std::initializer_list<std::pair<Real, At>> parts) {
      At sum = s;
      for (const auto& [weight, slope] : parts) {
        sum.overlap += h * weight * slope.overlap;
        sum.speed += h * weight * slope.speed;
      }
      return sum;
    };
    const auto f = [](int a, int b) { return Real(a) / b; };
    const At k1 = rate(s), k2 = rate(plus({{f(1, 4), k1}})), k3 = rate(plus({{f(1, 8), k1}, {f(1, 8), k2}}));
    const At k4 = rate(plus({{f(-1, 2), k2}, {Real(1), k3}}));
    const At k5 = rate(plus({{f(3, 16), k1}, {f(9, 16), k4}}));
    const At k6 = rate(plus({{f(-3, 7), k1}, {f(2, 7), k2}, {f(12, 7), k3}, {f(-12, 7), k4}, {f(8, 7), k5}}));
    return plus({{f(7, 90), k1}, {f(32, 90), k3}, {f(12, 90), k4}, {f(32, 90), k5}, {f(7, 90), k6}});
  }
};

struct Meeting {
  std::string label;
  double restitution;
  bool wall;
  bool free;
};

Scene hertz_scene(const Meeting& meeting) {
  Scene scene = glass_scene();
  scene.materials[0].elasticity = Elasticity{7e7, 0.25};
  scene.contacts.set(0, 0, {HertzNormal{Restitution{meeting.restitution}}});
  if (meeting.wall)
    add_floor(scene);
  else
    add_sphere(scene, Vec3::Zero(), Vec3(0, 0, meeting.free ? 0.5 : 0.0), !meeting.free, 0.06);
  add_sphere(scene, {0, 0, meeting.wall ? 0.05 : 0.08}, {0, 0, -1.0});
  return scene;
}

ExactHertz exact_of(const Scene& scene, const Meeting& meeting) {
  const Real pi = boost::math::constants::pi<Real>();
  const auto mass = [&](double d) { return Real(2000) * pi / 6 * Real(d) * Real(d) * Real(d); };
  const Real m = meeting.free ? Real(mass(0.1) * mass(0.06) / (mass(0.1) + mass(0.06))) : mass(0.1);
  const Real radius = meeting.wall ? Real(0.1) / 2 : Real(1 / (2 / Real(0.1) + 2 / Real(0.06)));
  const Elasticity& e = *scene.materials[0].elasticity;
  const Real modulus = Real(e.youngs_modulus) / (2 * (1 - Real(e.poisson_ratio) * e.poisson_ratio));
  const Real loss = log(Real(meeting.restitution));
  const Real beta = -loss / sqrt(loss * loss + pi * pi);
  const Real tangent = 2 * modulus * sqrt(radius);  // k_n/δ^(1/2)
  return {m, 2 * tangent / 3, 2 * beta * sqrt(Real(5) / 6 * m * tangent)};
}

class EveryHertzCollision : public testing::TestWithParam<Meeting> {};

// From an overlap of 1e-18 of the peak in steps that grow with the distance from the ends, where the law
// has only fractional powers: each step is 1/64 of the overlap's own time.
TEST_P(EveryHertzCollision, AgreesWithHighPrecisionIntegration) {
  Scene scene = hertz_scene(GetParam());
  const auto form = make_closed_form("hertz_collision");
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  const ExactHertz law = exact_of(scene, GetParam());
  const Real entry = GetParam().free ? 1.5 : 1.0;
  const double scale = form->observe(scene, {}).scalars.at("contact_duration");
  const Real cap = Real(scale) / 256, least = Real(scale) * entry * 1e-18;
  ExactHertz::At s{least, entry};
  Real time = s.overlap / entry, peak = 0;
  Request request;
  std::vector<ExactHertz::At> states;
  do {
    const Real own = s.overlap / (64 * abs(s.speed) + s.overlap);
    const Real h = own < cap ? own : cap;
    s = law.stepped(s, h);
    time += h;
    if (s.overlap > peak) peak = s.overlap;
    request.times.push_back(static_cast<double>(time));
    states.push_back(s);
  } while (s.overlap > least);
  const Observations seen = form->observe(scene, request);
  // Positions of 0.1 m carry 1e-17 each; a rounding of the time moves the speed by 1e-16/t_c of itself.
  for (std::size_t n = 0; n < states.size(); ++n) {
    const Frame& frame = seen.frames[n];
    const bool wall = GetParam().wall;
    const double gap = frame.position.back().z() - (wall ? 0.05 : frame.position[0].z() + 0.08);
    const double speed = frame.velocity.back().z() - (wall ? 0.0 : frame.velocity[0].z());
    ASSERT_NEAR(-gap, static_cast<double>(states[n].overlap), 1e-15) << n << " at " << frame.time;
    ASSERT_NEAR(-speed, static_cast<double>(states[n].speed), 1e-11) << n << " at " << frame.time;
  }
  EXPECT_GT(states.size(), 500u);
  EXPECT_NEAR(seen.scalars.at("peak_overlap") / static_cast<double>(peak), 1.0, 1e-5);
  EXPECT_NEAR(seen.scalars.at("contact_duration") / static_cast<double>(time), 1.0, 1e-11);
  EXPECT_NEAR(seen.scalars.at("restitution"), static_cast<double>(-s.speed / entry), 1e-11);
  EXPECT_NEAR(seen.scalars.at("restitution"), GetParam().restitution, 1e-15);
}

const Meeting meetings[] = {{"ElasticFixed", 1.0, false, false}, {"ElasticWall", 1.0, true, false},
                            {"ElasticFree", 1.0, false, true},   {"DampedWall", 0.8, true, false},
                            {"DampedFree", 0.5, false, true},    {"VeryDampedFixed", 0.1, false, false}};
INSTANTIATE_TEST_SUITE_P(, EveryHertzCollision, testing::ValuesIn(meetings),
                         [](const auto& param) { return param.param.label; });

TEST(HertzCollision, IsRefusedWhereSomethingElseActs) {
  const auto because = [](void (*spoil)(Scene&)) {
    Scene scene = hertz_scene({"", 1.0, true, false});
    spoil(scene);
    return make_closed_form("hertz_collision")->supports(scene, {}).because;
  };
  EXPECT_NE(because([](Scene& s) {
              s.contacts.set(0, 0, {LinearNormal{1e5, Restitution{1.0}}});
            }).find("linear"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) {
              s.gravity = ConstantGravity{{0, 0, -9.81}};
            }).find("gravity"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) { s.particles[0].velocity.z() = 1.0; }).find("never touch"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) {
              s.rotation = true;
              s.contacts.set(0, 0, {HertzNormal{Restitution{1.0}}, DynamicFriction{0.3}});
              s.particles[0].angular_velocity.x() = 1.0;
            }).find("spins"),
            std::string::npos);
}

/// Chung and Ooi (2011), cases 1 and 2, to the digits of their tables.
TEST(HertzPairs, HaveThePublishedPeaksForcesAndDurations) {
  struct Row {
    double youngs, poisson, density, radius, partner, speed, overlap, force, duration;
  };
  const double rigid = std::numeric_limits<double>::infinity();
  for (const Row& row : {Row{48e9, 0.20, 2800, 0.01, 0.01, 20, 274.11e-6, 10696.9, 40.34e-6},
                         Row{20e9, 0.25, 2500, 0.01, 0.01, 20, 368.30e-6, 7108.2, 54.20e-6},
                         Row{70e9, 0.30, 2699, 0.1, rigid, 0.2, 49.717e-6, 11369.9, 731.66e-6},
                         Row{40e9, 0.35, 1800, 0.1, rigid, 0.2, 52.123e-6, 7232.7, 767.07e-6}}) {
    const Elasticity e{row.youngs, row.poisson};
    const Elasticity other = std::isinf(row.partner) ? Elasticity{1e300, 0.3} : e;
    const double m = sphere_mass(row.density, 2 * row.radius);
    const HertzPair pair{std::isinf(row.partner) ? m : m / 2, effective_radius(row.radius, row.partner),
                         hertz_modulus(e, other), mindlin_modulus(e, other), 0.0};
    const double peak = pair.peak_overlap(row.speed);
    EXPECT_NEAR(peak / row.overlap, 1.0, 3e-5);
    EXPECT_NEAR(pair.force_constant() * std::pow(peak, 1.5) / row.force, 1.0, 3e-5);
    EXPECT_NEAR(pair.duration(row.speed) / row.duration, 1.0, 2e-4);
  }
}

TEST(HertzPairs, StiffnessIsTheSlopeOfTheForce) {
  const HertzPair pair{1.0, 0.05, 4e7, 1e7, 0.2};
  const double at = 1e-3, h = 1e-6;
  const auto force = [&](double overlap) { return pair.force_constant() * std::pow(overlap, 1.5); };
  EXPECT_NEAR(pair.normal_stiffness(at) / ((force(at + h) - force(at - h)) / (2 * h)), 1.0, 1e-6);
  EXPECT_NEAR(force(pair.resting_overlap(9.81)), 9.81, 1e-13);
}

TEST(HertzPairs, AreRefusedWithoutARestitutionAbove0) {
  EXPECT_THROW(hertz_damping_ratio(Restitution{0.0}), InputRefused);
  EXPECT_THROW(hertz_damping_ratio(Restitution{1.1}), InputRefused);
  EXPECT_THROW(hertz_damping_ratio(Restitution{std::nan("")}), InputRefused);
  EXPECT_THROW(hertz_damping_ratio(Damping{1.0}), InputRefused);
  EXPECT_EQ(hertz_damping_ratio(Restitution{1.0}), 0.0);
}

/// Equal spheres of G = E/(2(1 + ν)): Mindlin's k_t/k_n is 2(1 − ν)/(2 − ν).
TEST(E13, TangentialStiffnessOverNormalIsMindlins) {
  const double nu = 0.3;
  const Elasticity e{70e9, nu};
  const double ratio = 8.0 * mindlin_modulus(e, e) / (2.0 * hertz_modulus(e, e));
  EXPECT_NEAR(ratio, 2.0 * (1.0 - nu) / (2.0 - nu), 1e-14);
  const double shear = e.youngs_modulus / (2.0 * (1.0 + nu)), printed = shear / (2.0 * (1.0 - nu * nu));
  EXPECT_GT(std::abs(8.0 * printed / (2.0 * hertz_modulus(e, e)) - ratio), 0.5 * ratio);
}

TEST(ShortestContact, OfHertzLastsAsLongAsItsElasticImpact) {
  const Scene scene = hertz_scene({"", 1.0, false, true});
  const double duration =
      make_closed_form("hertz_collision")->observe(scene, {}).scalars.at("contact_duration");
  EXPECT_NEAR(shortest_contact(scene)->duration / duration, 1.0, 1e-13);
  EXPECT_NEAR(shortest_contact(scene, 1.5)->duration / duration, 1.0, 1e-13);
  EXPECT_FALSE(lacks_impact_speed(scene));
}

TEST(ShortestContact, OfHertzNeedsASpeed) {
  Scene scene = hertz_scene({"", 1.0, true, false});
  scene.particles[0].velocity.setZero();
  EXPECT_TRUE(lacks_impact_speed(scene));
  EXPECT_TRUE(std::isinf(shortest_contact(scene)->duration));
  scene.particles[0].fixed = true;
  EXPECT_FALSE(lacks_impact_speed(scene));  // nothing can touch
}

TEST(StabilityLimit, OfHertzIsThatOfItsStiffnessAtTheDeepestOverlap) {
  const Scene scene = hertz_scene({"", 1.0, true, false});
  const ContactScale scale = shortest_contact(scene).value();
  EXPECT_NEAR(stability_limit(scene).step, 2.0 * std::sqrt(scale.effective_mass / scale.stiffness), 1e-16);
  EXPECT_NE(stability_limit(scene).because.find("deepest overlap"), std::string::npos);
}

TEST(StabilityLimit, OfATangentialSpringTakesTwoSeventhsOfTheMassWhereBodiesTurn) {
  Scene scene = glass_scene({1e5, Restitution{1.0}});
  scene.contacts.set(0, 0, {LinearNormal{1e5, Restitution{1.0}}, HistoryFriction{0.3, 8e5, 0.0}});
  add_floor(scene);
  add_sphere(scene, {0, 0, 0.05}, {0, 0, -1.0});
  const double m = sphere_mass(2000.0, 0.1);
  EXPECT_NEAR(stability_limit(scene).step, 2.0 * std::sqrt(m / 8e5), 1e-16);
  scene.rotation = true;
  EXPECT_NEAR(stability_limit(scene).step, 2.0 * std::sqrt(2.0 * m / 7.0 / 8e5), 1e-16);
}

}  // namespace
}  // namespace grainproof::analytic
