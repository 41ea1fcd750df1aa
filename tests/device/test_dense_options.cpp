// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "crowds.hpp"
#include "opencl/dense_options.hpp"
#include "opencl/layout.hpp"
#include "opencl/width.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr double skin = 0.01;

Support support(const Scene& scene, Request request = {}) {
  return dense_support(scene, request, skin);
}

void expect_refused(const Scene& scene, const std::string& because, Request request = {}) {
  const Support seen = support(scene, request);
  EXPECT_FALSE(seen);
  EXPECT_NE(seen.because.find(because), std::string::npos) << seen.because;
}

TEST(DensePath, TakesABedWithHistoryRotationAndWalls) {
  EXPECT_TRUE(support(crowded_scene({})));
}

TEST(DensePath, TakesUnequalAndFixedSpheres) {
  EXPECT_TRUE(support(crowded_scene({.spread = 0.3, .fixed = true})));
}

TEST(DensePath, LeavesTheLedgerToTheZonedPath) {
  Request request;
  request.ledger = true;
  expect_refused(crowded_scene({}), "ledger", request);
}

TEST(DensePath, LeavesOtherLawsToTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.contacts.set(0, 0, {HertzNormal{Restitution{0.8}}});
  expect_refused(scene, "not linear");
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}}, Frictionless{}, LinearCohesion{1e3}});
  expect_refused(scene, "cohesion");
  scene.contacts.set(
      0, 0,
      {LinearNormal{stiffness, Restitution{0.8}}, Frictionless{}, NoCohesion{}, ConstantTorqueRolling{0.1}});
  expect_refused(scene, "rolling");
}

TEST(DensePath, LeavesFrictionBeyondItsSumsToTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}}, DynamicFriction{4.0}});
  EXPECT_TRUE(support(scene));
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{0.8}}, DynamicFriction{4.1}});
  expect_refused(scene, "above 4");
}

TEST(DensePath, LeavesOtherFieldsToTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.gravity = CentralGravity{9.81, Vec3::Zero()};
  expect_refused(scene, "gravity");
  scene = crowded_scene({});
  scene.flow = UniformFlow{1e-3, Vec3::Zero()};
  expect_refused(scene, "fluid");
  scene = crowded_scene({});
  for (const Integrator taken : {Integrator::velocity_verlet_predicted, Integrator::onset_corrected}) {
    scene = crowded_scene({});
    scene.run.integrator = taken;
    EXPECT_TRUE(support(scene));
  }
  scene.run.integrator = Integrator::euler_trapezoid;
  expect_refused(scene, "Verlet");
  scene = crowded_scene({});
  scene.remembered = {{1, 3, 0, Vec3::Zero()}};
  expect_refused(scene, "remember");
}

TEST(DensePath, LeavesOtherWallsAndMaterialsToTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.walls.push_back({"shelf", 0, Rectangle{Vec3::Zero(), Vec3(1, 1, 0)}});
  expect_refused(scene, "shelf");
  scene = crowded_scene({});
  scene.walls[0].motion = Translating{{1, 0, 0}};
  expect_refused(scene, "not a plane at rest");
  scene = crowded_scene({});
  scene.walls[0].shape = Plane{Vec3::Zero(), Vec3(0.6, 0.0, 0.8)};
  expect_refused(scene, "not parallel to a periodic axis");
  scene = crowded_scene({});
  scene.materials.push_back({"lead", 11000.0});
  scene.particles[5].material = 1;
  expect_refused(scene, "more than one material");
}

TEST(DensePath, NeedsAPeriodicBoxOfFiveReaches) {
  expect_refused(crowded_scene({.across = 3}), "shorter than five reaches");
}

TEST(DenseOptions, TakeOneParticleAWorkItemOnAGpu) {
  EXPECT_TRUE(takes_one(Width::automatic, true));
  EXPECT_FALSE(takes_one(Width::automatic, false));
  EXPECT_TRUE(takes_one(Width::one, false));
  EXPECT_FALSE(takes_one(Width::many, true));
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    const DenseOptions one = dense_options(crowded_scene({}), precision, true);
    EXPECT_EQ(lanes_of(one), 1);
    EXPECT_EQ(spans_of(one), group_size(one));
    EXPECT_EQ(window_size % group_size(one), 0);
    EXPECT_EQ(spans_of(dense_options(crowded_scene({}), precision)), 1);
  }
}

TEST(DensePath, LeavesContactsThatBeginOrEndToTheZonedPathWhereItTakesParticlesOneByOne) {
  Scene scene = crowded_scene({});
  scene.run.integrator = Integrator::velocity_verlet_predicted;
  EXPECT_TRUE(dense_support(scene, {}, skin, true));
  scene.run.integrator = Integrator::onset_corrected;
  const Support seen = dense_support(scene, {}, skin, true);
  EXPECT_FALSE(seen);
  EXPECT_NE(seen.because.find("onset_corrected"), std::string::npos) << seen.because;
}

TEST(DenseOptions, FollowFromTheSceneAlone) {
  const DenseOptions bed = dense_options(crowded_scene({}), Precision::single_precision);
  EXPECT_TRUE(bed.history && bed.rotation && bed.planes);
  EXPECT_FALSE(bed.friction || bed.varied || bed.canonical);
  EXPECT_EQ(bed.history_variant, remembers | turn_projects);
  Crowd gas{.friction = Frictionless{}, .rotation = false};
  gas.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  const DenseOptions lean = dense_options(crowded_scene(gas), Precision::single_precision);
  EXPECT_FALSE(lean.history || lean.rotation || lean.planes || lean.friction || lean.varied);
}

}  // namespace
}  // namespace grainproof::opencl::testing
