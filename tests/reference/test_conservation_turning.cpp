// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

double inertia(double d) {
  return 0.1 * sphere_mass(d) * d * d;
}

/// Sticky, rubbing, rolling spheres that run into each other, with nothing else around. With the arms
/// r − δ/2 the friction on both bodies of a pair acts at one point.
Scene free_gas(Integrator integrator, const RollingLaw& rolling) {
  ContactLaws laws = linear(1e5, Restitution{0.3});
  laws.friction = HistoryFriction{0.4, 3e4, 0.5, CoulombLimit::spring, TorqueArm::overlap};
  laws.cohesion = LinearCohesion{2e3};
  laws.rolling = rolling;
  Scene scene = empty_scene(laws, 5e-5);
  scene.run.integrator = integrator;
  scene.rotation = true;
  Random random(23);
  for (int i = 0; i < 125; ++i) {
    const Vec3 site = 0.14 * (Vec3(i % 5, i / 5 % 5, i / 25) - Vec3::Constant(2.0));
    const Vec3 velocity = random.in_box(Vec3::Constant(-1.0), Vec3::Constant(1.0)) - 3.0 * site;
    Particle& particle = add_particle(scene, random.between(0.07, 0.13), site, velocity);
    particle.effect_diameter = 1.1 * particle.diameter;
    particle.angular_velocity = random.in_box(Vec3::Constant(-20.0), Vec3::Constant(20.0));
  }
  return scene;
}

/// About the origin.
Vec3 angular_momentum(const Scene& scene, const Frame& frame) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double d = scene.particles[i].diameter;
    sum +=
        sphere_mass(d) * frame.position[i].cross(frame.velocity[i]) + inertia(d) * frame.angular_velocity[i];
  }
  return sum;
}

double spin_energy(const Scene& scene, const Frame& frame) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    sum += 0.5 * inertia(scene.particles[i].diameter) * frame.angular_velocity[i].squaredNorm();
  return sum;
}

// 125 bodies of some 1 kg, 3 m/s and 0.5 m in 3000 steps, each rounding its velocity at that arm.
void expect_conserved(const Scene& scene, double scheme_error = 0.0) {
  const auto run = start(scene);
  const Frame before = run->frame();
  run->advance(3000);
  const Frame after = run->frame();
  const double round_off = 0x1p-53 * std::sqrt(125.0 * 3000.0) * 10.0;
  EXPECT_LE((momentum(scene, after) - momentum(scene, before)).norm(), round_off);
  EXPECT_LE((angular_momentum(scene, after) - angular_momentum(scene, before)).norm(),
            round_off + scheme_error);
  EXPECT_LT(spin_energy(scene, after), 0.9 * spin_energy(scene, before));
  EXPECT_GT(run->state().contacts.size(), 50u);
}

// The trapezoidal Euler steps keep it up to their error only: x' × v' has (v × a) h²/2 too much.
TEST(TurningGas, KeepsMomentumAndAngularMomentumToRoundOff) {
  for (const Integrator integrator :
       {Integrator::velocity_verlet, Integrator::leapfrog_verlet, Integrator::velocity_verlet_predicted})
    for (const RollingLaw& rolling :
         {RollingLaw{NoRolling{}}, RollingLaw{ConstantTorqueRolling{0.1}}, RollingLaw{SpringRolling{0.1}}})
      expect_conserved(free_gas(integrator, rolling));
}

// What an event takes back points along the normal at the step's end, not at its start, and acts at places
// that it moves: 1.4e-6 N m s in some thousand events.
TEST(TurningGas, OnsetsKeepMomentumToRoundOffAndAngularMomentumUpToTheirError) {
  for (const RollingLaw& rolling :
       {RollingLaw{NoRolling{}}, RollingLaw{ConstantTorqueRolling{0.1}}, RollingLaw{SpringRolling{0.1}}})
    expect_conserved(free_gas(Integrator::onset_corrected, rolling), 5e-6);
}

}  // namespace
}  // namespace grainproof::testing
