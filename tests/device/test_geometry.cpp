// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

class Geometry : public ::testing::TestWithParam<Precision> {
 protected:
  Frame last_frame(Scene scene, double end) {
    scene.run.end = end;
    scene.run.sample_times = {0.0, end};
    return observed(options_for(GetParam()), scene).frames.back();
  }
  double roundings(double count) const { return count * roundoff(GetParam()); }
};

/// Two spheres on a collision course along `line`, their first touch at `middle`.
Scene pair_at(const Vec3& middle, const Vec3& line, Boundary boundary) {
  Scene scene = empty_scene(0.8);
  scene.domain.upper = {1.0, 0.7, 0.9};
  scene.domain.boundary = {boundary, boundary, boundary};
  const auto inside = [&](Vec3 x) {
    for (int axis = 0; axis < 3; ++axis)
      if (x[axis] >= scene.domain.upper[axis]) x[axis] -= scene.domain.extent()[axis];
    return x;
  };
  scene.particles = {sphere(0, inside(middle - 0.0502 * line), line),
                     sphere(1, inside(middle + 0.0504 * line), -2 * line)};
  return scene;
}

TEST_P(Geometry, PairsMeetThroughPeriodicFacesEdgesAndCorners) {
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 0), Vec3(0, 1, 1),
                                Vec3(1, 0, 1), Vec3(1, 1, 1)}) {
    const Vec3 line = direction.normalized();
    const Vec3 upper(1.0, 0.7, 0.9), centre(0.1, 0.05, -0.1);
    const Vec3 border = direction.cwiseProduct(upper) + (Vec3::Ones() - direction).cwiseProduct(centre);
    const Frame across = last_frame(pair_at(border, line, Boundary::periodic), 0.02);
    const Frame within = last_frame(pair_at(centre, line, Boundary::periodic), 0.02);
    EXPECT_LE((across.velocity[1] - within.velocity[1]).norm(), 3 * roundings(64) + 1e-11)
        << direction.transpose();
    EXPECT_GT((within.velocity[1] + 2 * line).norm(), 1.0);
  }
}

TEST_P(Geometry, AParticleCrossesPeriodicFacesWithoutLosingItsWay) {
  Scene scene = empty_scene(0.8);
  scene.domain = {
      Vec3(3, 4, 5), Vec3(4, 4.3, 5.7), {Boundary::periodic, Boundary::periodic, Boundary::periodic}};
  const Vec3 start(3.5, 4.1, 5.2), velocity(11, -7, 5);
  scene.particles = {sphere(0, start, velocity)};
  const Frame last = last_frame(scene, 1.0);
  Vec3 expected = start + velocity * last.time;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = scene.domain.extent()[axis];
    expected[axis] -= extent * std::floor((expected[axis] - scene.domain.lower[axis]) / extent);
  }
  // 14 m flown: the velocity's rounding times the distance, and for double a rounding a step.
  const double steps = GetParam() == Precision::double_precision ? last.time / scene.run.step : 1;
  EXPECT_LE((last.position[0] - expected).norm(), roundings(14 * steps));
}

TEST_P(Geometry, AParticleMayStopAnywhereOnAPeriodicFace) {
  // The extent is 0.44 over a whole number of single precision's quanta; centres are a twentieth of one
  // apart.
  constexpr double quantum = 0x1p-30 * 0.036;
  Scene scene = empty_scene(0.8);
  scene.domain = {
      Vec3(0, 0, 0), Vec3(0.007, 0.036, 0.007), {Boundary::periodic, Boundary::open, Boundary::open}};
  scene.run.step = scene.run.end = 2e-6;
  for (int i = 0; i < 60; ++i)
    scene.particles.push_back(
        sphere(i, {0.007 - 4e-8 + 0.05 * (i - 30) * quantum, 4e-4 * (i + 1), 0.003}, {0.02, 0, 0}, 1e-4));
  const Frame last = last_frame(scene, scene.run.end);
  for (const Vec3& x : last.position)
    EXPECT_LE(std::min(std::abs(x.x()), std::abs(x.x() - 0.007)), 3 * quantum) << x.x();
}

/// Thrown at the point `target` along `line`; with restitution 0.8 it comes back along the same line.
void expect_rebound(const Frame& last, const Vec3& line, double tolerance) {
  const Vec3 expected_direction = -line;
  EXPECT_LE((last.velocity[0].normalized() - expected_direction).norm(), tolerance);
  EXPECT_LE(std::abs(last.velocity[0].norm() / 0.8 - 1),
            3 * 2.9e-3);  // velocity Verlet at 64 steps per contact
}

Scene thrown_at_rectangle(const Vec3& target, const Vec3& line) {
  Scene scene = empty_scene(0.8);
  scene.walls = {{"plate", 0, Rectangle{{-0.2, -0.3, 0.1}, {0.2, 0.3, 0.1}}}};
  scene.particles = {sphere(0, target - 0.0503 * line, line)};
  return scene;
}

TEST_P(Geometry, RectanglesReboundFromFaceEdgeAndCornerOnBothSides) {
  for (const double side : {1.0, -1.0}) {
    const struct {
      Vec3 target, line;
    } throws[] = {{{0.05, 0.1, 0.1}, {0, 0, -side}},
                  {{0.2, 0.1, 0.1}, Vec3(-1, 0, -side).normalized()},
                  {{0.1, -0.3, 0.1}, Vec3(0, 2, -side).normalized()},
                  {{-0.2, 0.3, 0.1}, Vec3(1, -1, -side).normalized()}};
    for (const auto& [target, line] : throws)
      expect_rebound(last_frame(thrown_at_rectangle(target, line), 0.03), line, roundings(4096) + 1e-12);
  }
}

TEST_P(Geometry, ASphereBesideARectangleFliesPast) {
  const Frame last = last_frame(thrown_at_rectangle({0.2501, 0, 0.1}, {0, 0, -1}), 0.2);
  EXPECT_EQ(last.velocity[0], Vec3(0, 0, -1));
}

TEST_P(Geometry, ObliquePlanesReboundAlongTheirNormalWhereverTheSceneLies) {
  const Vec3 normal = Vec3(1, -2, 3).normalized();
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(-40, 3, 0.1)}) {
    Scene scene = empty_scene(0.8);
    scene.domain.lower += shift;
    scene.domain.upper += shift;
    const Vec3 foot = shift + Vec3(0.3, 0.2, -0.1);
    scene.walls = {{"ramp", 0, Plane{foot, normal}}};
    scene.particles = {sphere(0, foot + 0.0503 * normal, -normal)};
    expect_rebound(last_frame(scene, 0.03), -normal, roundings(64) + 1e-12);
  }
}

TEST_P(Geometry, WallsDampWithTheWholeMassAndFreePairsWithHalf) {
  Scene wall = settling_scene(1);
  wall.gravity = ConstantGravity{Vec3::Zero()};
  wall.particles = {sphere(0, {0, 0, 0.0503}, {0, 0, -1})};
  EXPECT_LE(std::abs(last_frame(wall, 0.03).velocity[0].z() / 0.8 - 1), 3 * 2.9e-3);
  Scene pair = empty_scene(0.8);
  pair.particles = {sphere(0, {-0.0503, 0, 0}, {1, 0, 0}), sphere(1, {0.0503, 0, 0}, {-1, 0, 0})};
  const Frame last = last_frame(pair, 0.03);
  EXPECT_LE(std::abs(last.velocity[1].x() / 0.8 - 1),
            3 * 4.1e-3);  // its contact is sqrt(2) shorter: 45 steps
  EXPECT_EQ(last.velocity[0], -last.velocity[1]);
}

TEST_P(Geometry, FixedParticlesStayWhereTheyAre) {
  const Scene scene = head_on_scene(0.8, 64);
  const auto seen = observed(options_for(GetParam()), scene);
  EXPECT_EQ(seen.frames.back().position[0], seen.frames.front().position[0]);
  EXPECT_EQ(seen.frames.back().velocity[0], Vec3::Zero());
}

TEST_P(Geometry, UnequalFreePairKeepsItsMomentum) {
  Scene scene = empty_scene(0.8);
  scene.particles = {sphere(0, {-0.0503, 0, 0}, {1, 0, 0}), sphere(1, {0.0103, 0, 0}, {0, 0, 0}, 0.02)};
  const Frame last = last_frame(scene, 0.03);
  const double heavy = sphere_mass(density, 0.1), light = sphere_mass(density, 0.02);
  EXPECT_LE(std::abs(heavy * last.velocity[0].x() + light * last.velocity[1].x() - heavy),
            heavy * roundings(32));
  EXPECT_GT(last.velocity[1].x(), 1.0);
}

/// A float knows a distance of 0.7 m to 4e-8 m, which is 4 % of this dent.
TEST_P(Geometry, ADentInACylinderIsKnownAsExactlyAsInAPlane) {
  for (const auto side : {Cylinder::Side::inside, Cylinder::Side::outside})
    for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(Vec3(1, -2, 3).normalized())}) {
      const double radius = 0.7, dent = 1e-6;
      const bool inside = side == Cylinder::Side::inside;
      const Vec3 point(0.1, -0.05, 0.02), away = axis.cross(Vec3(0.3, 1, 0)).normalized();
      Scene scene = empty_scene(0.8);
      scene.walls = {{"cylinder", 0, Cylinder{point + 0.3 * axis, axis, radius, side}}};
      const double distance = inside ? radius - 0.05 + dent : radius + 0.05 - dent;
      scene.particles = {sphere(0, point + distance * away, Vec3::Zero())};
      scene.run.integrator = Integrator::euler_trapezoid;
      const Vec3 gained = last_frame(scene, scene.run.step).velocity[0];
      const double mass = sphere_mass(density, diameter);
      const Vec3 expected = stiffness * dent / mass * scene.run.step * (inside ? Vec3(-away) : away);
      // The dent itself is a difference of doubles near 1 m.
      EXPECT_LE((gained - expected).norm(), (roundings(32) + 1e-9) * expected.norm()) << inside;
    }
}

GRAINPROOF_IN_EVERY_PRECISION(Geometry);

}  // namespace
}  // namespace grainproof::opencl::testing
