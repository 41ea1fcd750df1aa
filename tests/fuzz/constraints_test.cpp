// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The constraints that accepted files are held against: each must be missed by no scene that breaks it.
#include "tests/fuzz/constraints.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/input/example.hpp"

namespace grainproof::fuzz {
namespace {

struct Breach {
  const char* name;
  std::function<void(Case&)> commit;
};

Scene& scene_of(Case& read) {
  return read.scenes.front().scene;
}
ContactLaws& glass(Scene& scene) {
  return const_cast<ContactLaws&>(scene.contacts.at(0, 0));
}
Particle& second(Case& read) {
  return scene_of(read).particles[1];
}

class Constraints : public ::testing::TestWithParam<Breach> {};

TEST(Constraints, HoldInTheExample) {
  EXPECT_EQ(broken_constraint(read_text(example), {}), "");
}

TEST_P(Constraints, AreMissedByNone) {
  Case read = read_text(example);
  GetParam().commit(read);
  EXPECT_NE(broken_constraint(read, {}), "");
}

constexpr double none = std::numeric_limits<double>::quiet_NaN();

const Breach breaches[] = {
    {"NoScene", [](Case& read) { read.scenes.clear(); }},
    {"EndOfZero", [](Case& read) { scene_of(read).run.end = 0.0; }},
    {"StepThatIsNoNumber", [](Case& read) { scene_of(read).run.step = none; }},
    {"TooManySteps", [](Case& read) { scene_of(read).run.step = 1e-18; }},
    {"LimitWhereCentresMeet", [](Case& read) { scene_of(read).run.overlap_limit = 2.0; }},
    {"NegativeSkin", [](Case& read) { scene_of(read).run.skin = -0.5; }},
    {"SamplesTwice", [](Case& read) { scene_of(read).run.sample_times[1] = 0.0; }},
    {"SamplesBeyondTheEnd", [](Case& read) { scene_of(read).run.sample_times.back() *= 2.0; }},
    {"DomainInsideOut",
     [](Case& read) { std::swap(scene_of(read).domain.lower, scene_of(read).domain.upper); }},
    {"PeriodBelowTwoDiameters",
     [](Case& read) {
       scene_of(read).domain.boundary[0] = Boundary::periodic;
       for (Particle& particle : scene_of(read).particles) particle.effect_diameter = 1.5;
     }},
    {"NoDensity", [](Case& read) { scene_of(read).materials[0].density = 0.0; }},
    {"PoissonRatioOfOne",
     [](Case& read) {
       scene_of(read).materials[0].elasticity = {1e9, 1.0};
     }},
    {"NoLaws", [](Case& read) { scene_of(read).contacts = ContactTable(2); }},
    {"RestitutionAboveOne",
     [](Case& read) {
       glass(scene_of(read)).normal = LinearNormal{1e5, Restitution{1.1}};
     }},
    {"ReboundOfZeroWithoutTension",
     [](Case& read) {
       glass(scene_of(read)).normal = LinearNormal{1e5, Restitution{0.0}, true};
     }},
    {"HertzWithoutModuli", [](Case& read) { glass(scene_of(read)).normal = HertzNormal{Restitution{0.5}}; }},
    {"NegativeFriction", [](Case& read) { glass(scene_of(read)).friction = DynamicFriction{-0.1}; }},
    {"HistoryWithoutSpring",
     [](Case& read) {
       glass(scene_of(read)).friction = HistoryFriction{0.1, 0.0, 0.0};
     }},
    {"CohesionThatRepels", [](Case& read) { glass(scene_of(read)).cohesion = LinearCohesion{-1.0}; }},
    {"RollingWithoutRotation",
     [](Case& read) { glass(scene_of(read)).rolling = ConstantTorqueRolling{0.1}; }},
    {"NoDiameter", [](Case& read) { second(read).diameter = 0.0; }},
    {"EffectBelowBody", [](Case& read) { second(read).effect_diameter = 0.05; }},
    {"UnknownMaterial", [](Case& read) { second(read).material = 7; }},
    {"NowhereAtAll", [](Case& read) { second(read).position.x() = none; }},
    {"OutsideTheDomain", [](Case& read) { second(read).position.x() = 1.01; }},
    {"TheSameId", [](Case& read) { second(read).id = 1; }},
    {"FixedThatMoves", [](Case& read) { second(read).fixed = true; }},
    {"SpinWithoutRotation", [](Case& read) { second(read).angular_velocity.x() = 1.0; }},
    {"StrideOfADiameter", [](Case& read) { second(read).velocity.x() = 0.1 / scene_of(read).run.step; }},
    {"DeepInAnother", [](Case& read) { second(read).position.x() = 0.06; }},
    {"DeepInAnotherThroughAFace",
     [](Case& read) {
       scene_of(read).domain.boundary[0] = Boundary::periodic;
       scene_of(read).particles[0].position.x() = -1.0;
       second(read).position.x() = 0.95;
     }},
    {"DeepInAWall", [](Case& read) { second(read).position.z() = -0.49; }},
    {"NormalWithoutLength",
     [](Case& read) { std::get<Plane>(scene_of(read).walls[0].shape).normal = Vec3::Zero(); }},
    {"RectangleWithABody",
     [](Case& read) {
       scene_of(read).walls[0].shape = Rectangle{Vec3::Constant(0.7), Vec3::Constant(0.9)};
     }},
    {"WallThatNeverStandsStill",
     [](Case& read) {
       scene_of(read).walls[0].motion = Vibrating{Vec3::UnitZ(), 0.0, 0.0};
     }},
    {"GravityThatIsNoNumber",
     [](Case& read) { scene_of(read).gravity = ConstantGravity{Vec3(none, 0.0, 0.0)}; }},
    {"FlowWithoutViscosity",
     [](Case& read) {
       scene_of(read).flow = UniformFlow{0.0, Vec3::Zero()};
     }},
    {"OrientationWithoutRotation",
     [](Case& read) { scene_of(read).orientation = OrientationUpdate::exponential; }},
    {"ClaimOfNothing",
     [](Case& read) { read.expectations.push_back({.quantity = "x", .against = "value:1"}); }},
    {"ClaimOfNoPoint",
     [](Case& read) {
       read.expectations.push_back(
           {.quantity = "x", .against = "value:1", .where = {{"step", "no"}}, .below = {{"", 0.0}}});
     }},
    {"NegativeBound",
     [](Case& read) {
       read.expectations.push_back({.quantity = "x", .against = "value:1", .below = {{"", -1.0}}});
     }},
};

INSTANTIATE_TEST_SUITE_P(Breaches, Constraints, ::testing::ValuesIn(breaches),
                         [](const auto& breach) { return std::string(breach.param.name); });

}  // namespace
}  // namespace grainproof::fuzz
