// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "crowds.hpp"
#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

Outcome outcome_of(Path path, Scene scene, Width width = Width::many) {
  EngineOptions options = options_for(Precision::single_precision);
  options.skin = 0.01;
  options.path = path;
  options.width = width;
  OpenClEngine engine(options);
  return engine.observe(scene, {}).outcome;
}

void expect_same_failure(const Scene& scene, const std::string& words) {
  const Outcome zoned = outcome_of(Path::zoned, scene);
  for (const Width width : {Width::many, Width::one}) {
    const Outcome seen = outcome_of(Path::dense, scene, width);
    EXPECT_EQ(seen.status, Outcome::Status::went_wrong);
    EXPECT_NE(seen.reason.find(words), std::string::npos) << seen.reason;
    EXPECT_EQ(seen.reason, zoned.reason);
    EXPECT_EQ(seen.step, zoned.step);
    EXPECT_EQ(seen.particles, zoned.particles);
  }
}

TEST(DenseFailures, AnEscapeIsToldAsByTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.walls.clear();
  scene.domain.boundary[2] = Boundary::open;
  scene.particles.back().velocity = {0, 0, 80.0};
  expect_same_failure(scene, "left the domain through the upper z face");
}

// The device decides without what is below a unit of position, so it may see one outside that is inside by
// less.
TEST(DenseFailures, AnEscapeWithinRoundingOfAFaceHasAName) {
  Scene scene = crowded_scene({});
  scene.walls.clear();
  scene.gravity = ConstantGravity{Vec3::Zero()};
  scene.domain.boundary[2] = Boundary::open;
  scene.domain.upper[2] += 5 * diameter;
  scene.run.end = 8 * scene.run.step;
  Particle& top = scene.particles.back();
  top.velocity = {0, 0, 8.0};
  const double unit = 5 * diameter * 0x1p-32;
  for (int quarter = -4; quarter <= 4; ++quarter) {
    top.position[2] = scene.domain.upper[2] - 3 * 8.0 * scene.run.step + 0.25 * quarter * unit;
    const Outcome seen = outcome_of(Path::dense, scene);
    EXPECT_NE(seen.reason.find("left the domain through the upper z face"), std::string::npos) << seen.reason;
    EXPECT_EQ(seen.particles, std::vector<std::int64_t>{top.id});
  }
}

TEST(DenseFailures, TooDeepAnOverlapIsToldAsByTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.run.overlap_limit = 0.1;
  scene.particles[444].velocity = {30.0, 0, 0};
  expect_same_failure(scene, "overlaps particle");
}

TEST(DenseFailures, ALeapIsToldAsByTheZonedPathAndLessIsNone) {
  for (const double spread : {0.0, 0.2}) {
    Scene scene = crowded_scene({.spread = spread});
    Particle& top = scene.particles.back();
    const double radius_a_step = 0.5 * top.diameter / scene.run.step;
    top.velocity = {0, 0, 1.01 * radius_a_step};
    expect_same_failure(scene, "moved by more than its radius in one step");
    scene.walls.clear();
    scene.gravity = ConstantGravity{Vec3::Zero()};
    scene.domain.upper[2] += 5 * diameter;
    scene.run.end = 2 * scene.run.step;
    scene.run.sample_times = {0.0, scene.run.end};
    top.velocity = {0, 0, 0.97 * radius_a_step};
    EXPECT_EQ(outcome_of(Path::dense, scene).status, Outcome::Status::completed);
  }
}

TEST(DenseFailures, AWallTooDeepIsToldAsByTheZonedPath) {
  Scene scene = crowded_scene({});
  scene.run.overlap_limit = 0.1;
  scene.particles[4].velocity = {0, 0, -30.0};
  expect_same_failure(scene, "overlaps wall lower");
}

}  // namespace
}  // namespace grainproof::opencl::testing
