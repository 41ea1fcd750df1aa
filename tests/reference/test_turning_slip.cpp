// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/laws/tangential_spring.hpp"
#include "tests/reference/scenes.hpp"

/// Slip that turns while a contact slides, under `onset_corrected`.
namespace grainproof::testing {
namespace {

/// The angle between force and slip after a way of `length` times the limit over k_t, from `angle`.
double angle_after(double angle, double length, int steps) {
  const Vec3 moved(length / steps, 0.0, 0.0);
  Vec3 force(std::cos(angle), std::sin(angle), 0.0);
  for (int i = 0; i < steps; ++i) force = reference::returned_to_limit(force, force + moved, 1.0);
  return std::atan2(force.y(), force.x());
}

// Exactly, tan(φ/2) falls with the exponential of the way. Cut back along itself it is off by 2e-2 at 16
// steps and by 4e-3 at 64.
TEST(TurningSlip, ForceAtTheLimitFollowsItInSecondOrder) {
  const auto error = [](int steps) {
    const double exact = 2.0 * std::atan(std::tan(0.5) * std::exp(-1.5));
    return std::abs(angle_after(1.0, 1.5, steps) - exact);
  };
  EXPECT_LE(error(16), 1e-3);
  EXPECT_LE(error(64), 6e-5);
  EXPECT_GT(std::log2(error(64) / error(256)) / 2.0, 1.8);
}

TEST(TurningSlip, ForceThatDoesNotTurnIsCutBackAlongItself) {
  const Vec3 way(0.6, 0.0, 0.8);
  for (const double before : {-2.0, -1.0, 0.0, 0.5, 1.0, 3.0}) {
    const Vec3 left = reference::returned_to_limit(before * way, 2.5 * way, 2.0);
    EXPECT_LE((left - 2.0 * way).norm(), 1e-15) << before;
  }
}

TEST(TurningSlip, ForceEndsAtTheLimitWhateverItWas) {
  Random random(3);
  const auto any = [&] { return random.in_box(Vec3::Constant(-3.0), Vec3::Constant(3.0)); };
  for (int i = 0; i < 10000; ++i) {
    const Vec3 before = any(), trial = any();
    const double most = random.between(0.0, trial.norm());
    EXPECT_NEAR(reference::returned_to_limit(before, trial, most).norm(), most, 1e-14);
  }
  EXPECT_EQ(reference::returned_to_limit({1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0.0).norm(), 0.0);
}

constexpr double stiffness = 1e5, diameter = 0.1;

double pair_time() {
  return std::numbers::pi * std::sqrt(0.5 * sphere_mass(diameter) / stiffness);
}

/// A lattice without an end whose spheres overlap by 1 % and are kicked: most contacts slide, and slip turns.
Scene kicked_packing(int steps_per_contact) {
  constexpr int side = 4;
  constexpr double spacing = 0.99 * diameter;
  ContactLaws laws = linear(stiffness, Restitution{0.8});
  laws.friction = HistoryFriction{0.1, 2.0 / 7.0 * stiffness, 0.5};
  Scene scene = empty_scene(laws, pair_time() / steps_per_contact);
  scene.run.integrator = Integrator::onset_corrected;
  scene.rotation = true;
  scene.domain = {.lower = Vec3::Zero(), .upper = Vec3::Constant(side * spacing)};
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  Random random(5);
  const Vec3 most = Vec3::Constant(0.5);
  for (int i = 0; i < side * side * side; ++i) {
    const Vec3 place(i % side + 0.5, i / side % side + 0.5, i / (side * side) + 0.5);
    add_particle(scene, diameter, spacing * place, random.in_box(-most, most)).angular_velocity =
        10.0 * random.in_box(-most, most);
  }
  return scene;
}

constexpr int contacts = 4;  // times of one

std::vector<Vec3> velocities(int steps_per_contact) {
  return frame_after(kicked_packing(steps_per_contact), contacts * steps_per_contact).velocity;
}

double distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

// 7.2e-5 and 4.6e-6, order 1.98. Springs laid flat and cut back along themselves have 3.0e-4
// and 7.3e-5, 1.02.
TEST(TurningSlip, KickedPackingIsOfHigherThanFirstOrder) {
  const auto exact = velocities(4096);
  const double coarse = distance(velocities(64), exact), fine = distance(velocities(256), exact);
  EXPECT_GT(std::log2(coarse / fine) / 2.0, 1.4);
  EXPECT_LE(fine, 1e-5);
}

}  // namespace
}  // namespace grainproof::testing
