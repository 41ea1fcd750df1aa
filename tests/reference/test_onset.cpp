// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double stiffness = 1e5, diameter = 0.1;

/// Half a period of the free contact, s.
double contact_time(double restitution, double mass) {
  const double log = std::log(restitution), turn = std::numbers::pi * std::numbers::pi;
  return std::sqrt(mass * (turn + log * log) / stiffness);
}

struct Rms {
  double sum = 0.0;
  int count = 0;

  void add(double error) {
    sum += error * error;
    ++count;
  }
  double value() const { return std::sqrt(sum / count); }
};

/// A pair along x that touches `ahead` (s) after the start at 1 m/s.
Scene pair(const ContactLaws& laws, Integrator integrator, double step, double ahead) {
  Scene scene = empty_scene(laws, step);
  scene.run.integrator = integrator;
  const double half = 0.5 * (diameter + ahead);
  add_particle(scene, diameter, {-half, 0.0, 0.0}, {0.5, 0.0, 0.0});
  add_particle(scene, diameter, {half, 0.0, 0.0}, {-0.5, 0.0, 0.0});
  return scene;
}

Scene sphere_and_wall(const ContactLaws& laws, Integrator integrator, double step, double ahead) {
  Scene scene = empty_scene(laws, step);
  scene.run.integrator = integrator;
  add_plane(scene, Vec3::Zero(), Vec3::UnitX());
  add_particle(scene, diameter, {0.5 * diameter + ahead, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  return scene;
}

double rebound(const Scene& scene, int steps) {
  const Frame frame = frame_after(scene, steps);
  return scene.walls.empty() ? (frame.velocity[1] - frame.velocity[0]).x() : frame.velocity[0].x();
}

enum class Against { sphere, wall };

/// Relative error of the restitution over random onset phases and ratios of contact time and step.
double rebound_error(Against against, double restitution, int steps_per_contact,
                     Integrator integrator = Integrator::onset_corrected) {
  const double mass = sphere_mass(diameter) * (against == Against::wall ? 1.0 : 0.5);
  Random random(7);
  Rms rms;
  for (int i = 0; i < 128; ++i) {
    const double step =
        contact_time(restitution, mass) / (steps_per_contact * (1.0 + random.between(-0.1, 0.1)));
    const auto make = against == Against::wall ? sphere_and_wall : pair;
    const Scene scene =
        make(linear(stiffness, Restitution{restitution}), integrator, step, random.between(0.0, 1.0) * step);
    rms.add(rebound(scene, static_cast<int>(1.3 * steps_per_contact) + 8) / restitution - 1.0);
  }
  return rms.value();
}

class OnsetAgainst : public ::testing::TestWithParam<Against> {};

// An independent integration in one dimension has 1.7e-4 and 1.8e-5; velocity Verlet 1.2e-2 and 2.9e-3.
TEST_P(OnsetAgainst, DampedReboundIsFarMoreAccurate) {
  EXPECT_LE(rebound_error(GetParam(), 0.8, 16), 5e-4);
  EXPECT_LE(rebound_error(GetParam(), 0.8, 64), 3e-5);
}

// Three octaves, statistics of 128 samples.
TEST_P(OnsetAgainst, DampedReboundIsOfSecondOrder) {
  for (const double restitution : {0.3, 0.5, 0.8}) {
    const double coarse = rebound_error(GetParam(), restitution, 64);
    const double fine = rebound_error(GetParam(), restitution, 512);
    EXPECT_GT(std::log2(coarse / fine) / 3.0, 1.8) << restitution;
  }
}

TEST_P(OnsetAgainst, ElasticReboundIsOfFourthOrder) {
  EXPECT_LE(rebound_error(GetParam(), 1.0, 32), 1e-5);
  EXPECT_LE(rebound_error(GetParam(), 1.0, 128), 3e-8);
  EXPECT_GT(rebound_error(GetParam(), 1.0, 32, Integrator::velocity_verlet), 3e-4);
}

INSTANTIATE_TEST_SUITE_P(Bodies, OnsetAgainst, ::testing::Values(Against::sphere, Against::wall),
                         [](const auto& against) {
                           return against.param == Against::wall ? std::string("Wall") : "Sphere";
                         });

// The dashpot alone at the predicted velocity leaves the error of the onset as it was.
TEST(Onset, PredictionAloneDoesNotHelpARebound) {
  EXPECT_GT(rebound_error(Against::sphere, 0.8, 64, Integrator::velocity_verlet_predicted), 1e-3);
}

// Critical and more than critical damping have flows of their own; against the same scheme at a fine step.
TEST(Onset, OverdampedContactIsOfSecondOrder) {
  const double mass = 0.5 * sphere_mass(diameter), critical = 2.0 * std::sqrt(mass * stiffness);
  for (const double damping : {critical, 1.5 * critical}) {
    const auto approach = [&](int steps) {
      const double until = 0.02, step = until / steps;
      const Scene scene =
          pair(linear(stiffness, Damping{damping}), Integrator::onset_corrected, step, 0.00123);
      return rebound(scene, steps);
    };
    const double fine = approach(64 * 200);
    EXPECT_LE(std::abs(approach(400) - fine), 0.3 * std::abs(approach(200) - fine) + 1e-6);
    EXPECT_LE(std::abs(approach(400) - fine), 1e-3);
  }
}

/// Between two walls: the share of its energy that a sphere has gained in some bounces without a dashpot.
double drift(int steps_per_contact, int bounces) {
  const double step = contact_time(1.0, sphere_mass(diameter)) / (steps_per_contact * 1.0137);
  Scene scene = empty_scene(linear(stiffness, Restitution{1.0}), step);
  scene.run.integrator = Integrator::onset_corrected;
  add_plane(scene, Vec3::Zero(), Vec3::UnitX());
  add_plane(scene, {0.1 + 10.0371 * step, 0.0, 0.0}, -Vec3::UnitX());
  add_particle(scene, diameter, {0.05 + 5.3 * step, 0.0, 0.0}, {-1.0, 0.0, 0.0});
  const auto run = start(scene, true);
  const double before = run->ledger().kinetic;
  run->advance(static_cast<std::int64_t>(bounces) * (steps_per_contact + 10));
  const Ledger ledger = run->ledger();
  return (ledger.kinetic + ledger.elastic) / before - 1.0;
}

// Beginning and ending undo each other, so what is left is Verlet's own swing of energy within a contact.
TEST(Onset, ElasticBouncesDoNotDrift) {
  EXPECT_LE(std::abs(drift(32, 20000)), 3e-3);
  EXPECT_LE(std::abs(drift(64, 20000)), 8e-4);
}

/// Sphere that never leaves a wall.
Frame resting(Integrator integrator) {
  Scene scene = empty_scene(linear(stiffness, Restitution{1.0}), 1e-4);
  scene.run.integrator = integrator;
  scene.gravity = ConstantGravity{{-9.81, 0.0, 0.0}};
  add_plane(scene, Vec3::Zero(), Vec3::UnitX());
  add_particle(scene, diameter, {0.5 * diameter - 1e-4, 0.0, 0.0}, {-0.001, 0.3, 0.0});
  return frame_after(scene, 1000);
}

TEST(Onset, LastingContactIsThePlainSchemeToTheBit) {
  const Frame plain = resting(Integrator::velocity_verlet);
  for (const Integrator integrator : {Integrator::velocity_verlet_predicted, Integrator::onset_corrected}) {
    const Frame frame = resting(integrator);
    EXPECT_EQ(frame.position[0], plain.position[0]);
    EXPECT_EQ(frame.velocity[0], plain.velocity[0]);
  }
}

/// Spheres meet obliquely, spinning, with friction that remembers.
Scene oblique(Integrator integrator, double restitution, double coefficient, double step, double ahead) {
  ContactLaws laws = linear(stiffness, Restitution{restitution});
  laws.friction = HistoryFriction{coefficient, 2.0 / 7.0 * stiffness, 0.5};
  Scene scene = empty_scene(laws, step);
  scene.run.integrator = integrator;
  scene.rotation = true;
  const Vec3 velocity(-1.0, 0.8, 0.3), apart = Vec3(diameter, 0.0, 0.0) - ahead * velocity;
  add_particle(scene, diameter, -0.5 * apart, -0.5 * velocity).angular_velocity = {0.0, 3.0, 5.0};
  add_particle(scene, diameter, 0.5 * apart, 0.5 * velocity).angular_velocity = {1.0, 0.0, -2.0};
  return scene;
}

struct Outcome {
  Vec3 velocity, surface;
};

Outcome outcome(Integrator integrator, double restitution, double coefficient, double steps_per_contact,
                double phase) {
  const double contact = contact_time(restitution, 0.5 * sphere_mass(diameter));
  const double step = contact / steps_per_contact;
  const Frame frame = frame_after(oblique(integrator, restitution, coefficient, step, phase * step),
                                  static_cast<std::int64_t>(1.5 * steps_per_contact) + 8);
  return {frame.velocity[1], 0.5 * diameter * frame.angular_velocity[1]};
}

double oblique_error(Integrator integrator, double restitution, double coefficient, int steps_per_contact) {
  const Outcome exact = outcome(Integrator::onset_corrected, restitution, coefficient, 8192, 0.3);
  Random random(7);
  Rms rms;
  for (int i = 0; i < 32; ++i) {
    const double ratio = steps_per_contact * (1.0 + random.between(-0.1, 0.1));
    const Outcome seen = outcome(integrator, restitution, coefficient, ratio, random.between(0.0, 1.0));
    rms.add((seen.velocity - exact.velocity).norm());
    rms.add((seen.surface - exact.surface).norm());
  }
  return rms.value();
}

// Four octaves. Velocity Verlet has 1.8e-4 at 512 with 0.8.
TEST(Onset, ObliqueCollisionWithHistoryIsOfSecondOrder) {
  for (const double restitution : {0.3, 0.5, 0.8}) {
    const double coarse = oblique_error(Integrator::onset_corrected, restitution, 1.0, 32);
    const double fine = oblique_error(Integrator::onset_corrected, restitution, 1.0, 512);
    EXPECT_GT(std::log2(coarse / fine) / 4.0, 1.75) << restitution;
    EXPECT_LE(fine, 6e-6) << restitution;
  }
}

// Small from coarse steps on, so that there is no order to see.
TEST(Onset, ObliqueElasticCollisionIsMoreAccurateThanVerlet) {
  EXPECT_LE(oblique_error(Integrator::onset_corrected, 1.0, 1.0, 32),
            oblique_error(Integrator::velocity_verlet, 1.0, 1.0, 32) / 3.0);
  EXPECT_LE(oblique_error(Integrator::onset_corrected, 1.0, 1.0, 512), 5e-6);
}

// Across a periodic face, and with the ids the other way round, a collision is the same one.
TEST(Onset, FacesAndNumbersMakeNoDifference) {
  const Scene plain = oblique(Integrator::onset_corrected, 0.8, 0.3, 2e-4, 1.3e-4);
  Scene shifted = plain;
  shifted.domain = {.lower = {0.0, -1.0, -1.0}, .upper = {1.0, 1.0, 1.0}};
  shifted.domain.boundary[0] = Boundary::periodic;
  Scene swapped = plain;
  std::swap(swapped.particles[0], swapped.particles[1]);
  swapped.particles[0].id = 1;
  swapped.particles[1].id = 2;
  const Frame one = frame_after(plain, 80), two = frame_after(shifted, 80), three = frame_after(swapped, 80);
  ASSERT_GT((one.velocity[0] - plain.particles[0].velocity).norm(), 0.1);
  for (const int i : {0, 1}) {
    EXPECT_LE((one.velocity[i] - two.velocity[i]).norm(), 1e-11);
    EXPECT_LE((one.velocity[i] - three.velocity[1 - i]).norm(), 1e-11);
    EXPECT_LE((one.angular_velocity[i] - three.angular_velocity[1 - i]).norm(), 1e-9);
  }
}

// Let go where spring and dashpot cancel, before the bodies part.
TEST(Onset, ContactThatNeverPullsIsOfSecondOrder) {
  const auto error = [](int steps_per_contact) {
    const double mass = 0.5 * sphere_mass(diameter);
    Random random(7);
    Rms rms;
    for (int i = 0; i < 64; ++i) {
      const double step = contact_time(0.8, mass) / (steps_per_contact * (1.0 + random.between(-0.1, 0.1)));
      const Scene scene = pair(linear(stiffness, Restitution{0.8}, true), Integrator::onset_corrected, step,
                               random.between(0.0, 1.0) * step);
      rms.add(rebound(scene, 2 * steps_per_contact) / 0.8 - 1.0);
    }
    return rms.value();
  };
  EXPECT_LE(error(16), 1e-3);
  EXPECT_LE(error(64), 6e-5);
}

}  // namespace
}  // namespace grainproof::testing
