// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/side_by_side.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/app/scenes.hpp"

namespace grainproof::testing {
namespace {

report::Seen seen_by(const std::string& engine, std::vector<Frame> frames) {
  report::Seen seen{engine, {}};
  seen.observations.frames = std::move(frames);
  return seen;
}

TEST(SideBySide, IsRelativeToDiameterAndLargestSpeed) {
  Scene scene = spheres_at({{1, 1, 1}, {3, 3, 3}});
  scene.particles[0].velocity = {0, 0, 4};
  Frame moved = frame_of(scene);
  moved.position[1].x() += 0.25;
  moved.velocity[0].z() = 3.0;
  const auto apart = report::difference(scene, seen_by("a", {frame_of(scene)}), seen_by("b", {moved}));
  ASSERT_EQ(apart.frames.size(), 1U);
  EXPECT_DOUBLE_EQ(apart.frames[0].position, 0.25);
  EXPECT_DOUBLE_EQ(apart.frames[0].velocity, 0.25);
}

TEST(SideBySide, SpinCountsAsTheSpeedOfTheSurface) {
  const Scene scene = spheres_at({{1, 1, 1}, {3, 3, 3}});
  Frame turning = frame_of(scene);
  turning.angular_velocity = {Vec3(0, 8, 0), Vec3::Zero()};
  Frame slower = turning;
  slower.angular_velocity[0].y() = 6.0;
  const auto apart = report::difference(scene, seen_by("a", {turning}), seen_by("b", {slower}));
  EXPECT_DOUBLE_EQ(apart.scale.speed, 4.0);
  EXPECT_DOUBLE_EQ(apart.frames[0].spin, 0.25);
  EXPECT_EQ(apart.frames[0].velocity, 0.0);
}

TEST(SideBySide, TakesTheShortWayThroughAPeriodicFace) {
  const Scene scene = spheres_at({{0.01, 1, 1}}, Boundary::periodic);
  Frame other = frame_of(scene);
  other.position[0].x() = 9.99;
  const auto apart = report::difference(scene, seen_by("a", {frame_of(scene)}), seen_by("b", {other}));
  EXPECT_NEAR(apart.frames[0].position, 0.02, 1e-12);
}

TEST(SideBySide, DoesNotHideANumberThatIsNone) {
  const Scene scene = spheres_at({{1, 1, 1}, {3, 3, 3}});
  Frame broken = frame_of(scene);
  broken.position[0].y() = std::numeric_limits<double>::quiet_NaN();
  const auto apart = report::difference(scene, seen_by("a", {frame_of(scene)}), seen_by("b", {broken}));
  EXPECT_TRUE(std::isnan(apart.frames[0].position));
}

TEST(SideBySide, CountsFramesWithoutACounterpart) {
  const Scene scene = spheres_at({{1, 1, 1}});
  const auto apart = report::difference(scene, seen_by("a", {frame_of(scene, 0), frame_of(scene, 5)}),
                                        seen_by("b", {frame_of(scene, 0), frame_of(scene, 6)}));
  EXPECT_EQ(apart.frames.size(), 1U);
  EXPECT_EQ(apart.unmatched, 2U);
}

}  // namespace
}  // namespace grainproof::testing
