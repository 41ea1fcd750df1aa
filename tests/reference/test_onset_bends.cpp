// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Oblique collisions whose friction bends within a step (integrators.21), against the same scheme at a step
// so short that it matters no more.
#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

constexpr double stiffness = 1e5, diameter = 0.1;

struct Impact {
  bool wall;
  double restitution, coefficient;

  double contact_time() const {
    const double log = std::log(restitution), turn = std::numbers::pi * std::numbers::pi;
    const double mass = sphere_mass(diameter) * (wall ? 1.0 : 0.5);
    return std::sqrt(mass * (turn + log * log) / stiffness);
  }
};

struct Start {
  Vec3 velocity, first, second;  ///< of approach, m/s; spins, rad/s
};

Scene scene_of(const Impact& impact, const Start& start, Integrator integrator, double step, double ahead) {
  ContactLaws laws = linear(stiffness, Restitution{impact.restitution});
  laws.friction = HistoryFriction{impact.coefficient, 0.37 * stiffness, impact.restitution < 1.0 ? 0.5 : 0.0};
  Scene scene = empty_scene(laws, step);
  scene.run.integrator = integrator;
  scene.rotation = true;
  const auto add = [&](const Vec3& position, const Vec3& velocity, const Vec3& spin) {
    add_particle(scene, diameter, position, velocity).angular_velocity = spin;
  };
  const Vec3 apart = Vec3(impact.wall ? 0.5 * diameter : diameter, 0.0, 0.0) - ahead * start.velocity;
  if (impact.wall) {
    add_plane(scene, Vec3::Zero(), Vec3::UnitX());
    add(apart, start.velocity, start.second);
  } else {
    add(-0.5 * apart, -0.5 * start.velocity, start.first);
    add(0.5 * apart, 0.5 * start.velocity, start.second);
  }
  return scene;
}

struct Outcome {
  Vec3 velocity, surface;
};

Outcome outcome(const Impact& impact, const Start& start, Integrator integrator, double steps_per_contact,
                double phase) {
  const double step = impact.contact_time() / steps_per_contact;
  const Frame frame = frame_after(scene_of(impact, start, integrator, step, phase * step),
                                  static_cast<std::int64_t>(1.5 * steps_per_contact) + 8);
  const int body = impact.wall ? 0 : 1;
  return {frame.velocity[body], 0.5 * diameter * frame.angular_velocity[body]};
}

/// Root mean square over slants up to 69°, spins and phases of the onset, m/s at 1 m/s.
double error_of(const Impact& impact, Integrator integrator, int steps_per_contact, double spin) {
  Random random(11);
  double sum = 0.0;
  constexpr int collisions = 12, phases = 4;
  for (int k = 0; k < collisions; ++k) {
    const double slip = std::tan(random.between(0.0, 1.2)), turn = random.between(0.0, 6.28);
    Start start{Vec3(-1.0, slip * std::cos(turn), slip * std::sin(turn)), {}, {}};
    start.first = random.in_box(Vec3::Constant(-spin), Vec3::Constant(spin));
    start.second = random.in_box(Vec3::Constant(-spin), Vec3::Constant(spin));
    const Outcome exact = outcome(impact, start, Integrator::onset_corrected, 4096, 0.3);
    for (int i = 0; i < phases; ++i) {
      const double ratio = steps_per_contact * (1.0 + random.between(-0.1, 0.1));
      const Outcome seen = outcome(impact, start, integrator, ratio, random.between(0.0, 1.0));
      sum += (seen.velocity - exact.velocity).squaredNorm() + (seen.surface - exact.surface).squaredNorm();
    }
  }
  return std::sqrt(sum / (collisions * phases));
}

double times_better(const Impact& impact) {
  return error_of(impact, Integrator::velocity_verlet, 32, 10.0) /
         error_of(impact, Integrator::onset_corrected, 32, 10.0);
}

// Without these events 8 to 12 times where there is a dashpot, 2.2 to 3.7 times where there is none.
TEST(OnsetBends, CoarseStepsAreFarMoreAccurateThanVerlets) {
  for (const bool wall : {true, false})
    for (const double coefficient : {0.1, 0.5, 2.0}) {
      EXPECT_GE(times_better({wall, 0.8, coefficient}), 70.0) << wall << ' ' << coefficient;
      EXPECT_GE(times_better({wall, 1.0, coefficient}), 7.0) << wall << ' ' << coefficient;
    }
}

// By the normal of now a sphere that slides on another would bend at every step: 4.7e-6 and more. Where the
// force passes zero by the contact's own motion, as if they did not roll round each other, the last
// has 1.3e-5.
TEST(OnsetBends, SpheresThatRollRoundEachOtherAreNoLessAccurate) {
  EXPECT_LE(error_of({false, 0.3, 0.1}, Integrator::onset_corrected, 512, 0.0), 1.5e-6);
  EXPECT_LE(error_of({false, 0.5, 0.1}, Integrator::onset_corrected, 512, 0.0), 8e-7);
  EXPECT_LE(error_of({false, 0.3, 2.0}, Integrator::onset_corrected, 512, 0.0), 2.5e-6);
}

}  // namespace
}  // namespace grainproof::testing
