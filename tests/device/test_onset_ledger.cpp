// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// (integrators.19): what contacts that begin or end within a step do beside the forces is in the ledger. It
// closes with the integrator's order, and entry by entry it is the reference's.
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "crowds.hpp"
#include "device_fixture.hpp"
#include "opencl/pair_laws.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "scenes.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Ran {
  Frame frame;
  Ledger before, after;
  std::uint64_t digest = 0;
};

Ran ran(SteppingEngine& engine, const Scene& scene, std::int64_t steps, bool ledger = true) {
  Request request;
  request.ledger = ledger;
  const auto run = engine.start(scene, request);
  Ran seen;
  seen.before = run->ledger();
  run->advance(steps);
  seen.after = run->ledger();
  seen.frame = run->frame();
  seen.digest = run->digest();
  return seen;
}

Ran ran_on_device(Precision precision, Path path, const Scene& scene, std::int64_t steps,
                  bool ledger = true) {
  EngineOptions options = options_for(precision);
  options.path = path;
  OpenClEngine engine(options);
  return ran(engine, scene, steps, ledger);
}

/// One of the varied scenes, or a few hundred spheres in a box with two periodic directions.
Scene scene_of(const std::string& name, Integrator integrator = Integrator::onset_corrected) {
  Scene scene = name == "gas" ? crowded_scene({.across = 7, .layers = 7, .spread = 0.2}) : varied_scene(name);
  scene.run.integrator = integrator;
  return scene;
}

constexpr std::array energies{&Ledger::kinetic,           &Ledger::elastic,
                              &Ledger::cohesive,          &Ledger::gravity_work,
                              &Ledger::drag_work,         &Ledger::wall_work,
                              &Ledger::dissipated_normal, &Ledger::dissipated_tangential,
                              &Ledger::dissipated_rolling};

using Way = std::tuple<std::string, Path, Integrator>;

class OnsetLedgerOf : public ::testing::TestWithParam<Way> {};

TEST_P(OnsetLedgerOf, IsTheReferencesEntryByEntry) {
  constexpr std::int64_t steps = 100;
  const auto& [name, path, integrator] = GetParam();
  const Scene scene = scene_of(name, integrator);
  reference::ReferenceEngine reference;
  const Ledger expected = ran(reference, scene, steps).after;
  const Ledger seen = ran_on_device(Precision::double_precision, path, scene, steps).after;
  // As in test_against_reference.cpp: round-off of some hundred steps.
  for (std::size_t k = 0; k < energies.size(); ++k)
    EXPECT_LE(std::abs(seen.*energies[k] - expected.*energies[k]), 1e-11 * expected.kinetic) << k;
  const double given = expected.support_impulse.norm();
  EXPECT_LE((seen.support_impulse - expected.support_impulse).norm(), 1e-11 * given);
  EXPECT_GT(given, 0.0);
  ASSERT_EQ(seen.wall_impulses.size(), expected.wall_impulses.size());
  for (std::size_t k = 0; k < expected.wall_impulses.size(); ++k) {
    EXPECT_LE((seen.wall_impulses[k] - expected.wall_impulses[k]).norm(), 1e-11 * given) << k;
    EXPECT_LE((seen.wall_angular_impulses[k] - expected.wall_angular_impulses[k]).norm(), 1e-11 * given) << k;
  }
}

constexpr Integrator corrects = Integrator::onset_corrected;

INSTANTIATE_TEST_SUITE_P(
    Scenes, OnsetLedgerOf,
    ::testing::Values(Way{"velocity_verlet", Path::small, corrects}, Way{"drum", Path::small, corrects},
                      Way{"paddle", Path::small, corrects},
                      Way{"turning_in_rectangles", Path::zoned, corrects},
                      Way{"hertz_and_springs", Path::zoned, corrects},
                      Way{"rolling_steadily", Path::small, corrects},
                      Way{"turning_liggghts", Path::small, Integrator::velocity_verlet_predicted},
                      Way{"turning_liggghts", Path::small, Integrator::velocity_verlet_implicit}),
    [](const ::testing::TestParamInfo<Way>& param) {
      return std::get<0>(param.param) + "_" + std::string(name_of(std::get<2>(param.param)));
    });

/// Spheres that hit a wall, or each other, each at a phase of the step of its own.
Scene impacts(const ContactLaws& laws, bool oblique, bool wall, double steps_per_contact) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  Scene scene = empty_scene(0.8);
  scene.run.integrator = Integrator::onset_corrected;
  scene.rotation = oblique;
  scene.materials[0].elasticity = Elasticity{1e7, 0.3};
  scene.contacts.set(0, 0, laws);
  scene.run.step = contact_time(sphere_mass(density, diameter) / 2, stiffness, 0.8) / steps_per_contact;
  if (wall) scene.walls = {{"wall", 0, Plane{Vec3::Zero(), Vec3::UnitX()}}};
  for (int k = 0; k < 30; ++k) {
    const Vec3 at(0.0, -0.85 + 0.34 * (k % 6), -0.85 + 0.34 * (k / 6));
    const Vec3 slip = oblique ? Vec3(0.0, 0.7 * even(random), 0.7 * even(random)) : Vec3::Zero();
    const double gap = scene.run.step * (1.5 + 0.5 * even(random));
    scene.particles.push_back(sphere(2 * k, at + Vec3(diameter / 2 + gap, 0, 0), slip - Vec3::UnitX()));
    if (oblique)
      scene.particles.back().angular_velocity = 10.0 * Vec3(even(random), even(random), even(random));
    if (!wall) scene.particles.push_back(sphere(2 * k + 1, at - Vec3(diameter / 2, 0, 0), Vec3::UnitX()));
  }
  return scene;
}

/// What the ledger misses of the energy that there was, once all have parted; steps per contact of the linear
/// law.
double missed(const ContactLaws& laws, bool oblique, bool wall, double steps) {
  const Scene scene = impacts(laws, oblique, wall, steps);
  const auto end = static_cast<std::int64_t>(3.0 * steps);
  const Ran seen = ran_on_device(Precision::double_precision, Path::small, scene, end);
  EXPECT_EQ(seen.after.elastic, 0.0);
  return std::abs(seen.after.balance() - seen.before.balance()) / seen.before.kinetic;
}

void expect_second_order(const ContactLaws& laws, bool oblique, bool wall, const char* what) {
  const double coarse = missed(laws, oblique, wall, 32.3), fine = missed(laws, oblique, wall, 258.4);
  EXPECT_GE(std::log2(coarse / fine) / 3.0, 1.85) << what << ": " << coarse << ", " << fine;
  EXPECT_LE(fine, 2e-5) << what;  // (ω h)² is 1.5e-4
}

const HistoryFriction springs{0.3, stiffness * 2 / 7, 0.5};

TEST(OnsetLedgerInDouble, ClosesInSecondOrder) {
  const LinearNormal linear{stiffness, Restitution{0.8}, false};
  expect_second_order({linear, Frictionless{}, NoCohesion{}}, false, false, "head-on");
  expect_second_order({linear, springs, NoCohesion{}}, true, false, "oblique pairs");
  expect_second_order({linear, springs, NoCohesion{}}, true, true, "oblique on a wall");
  expect_second_order({HertzNormal{Restitution{0.8}}, Frictionless{}, NoCohesion{}}, false, false, "Hertz");
}

// The rebound itself is of fourth order; what is booked as dissipated is the ledger's own error.
TEST(OnsetLedgerInDouble, ElasticPairsLoseNothingButTheLedgersOwnError) {
  const ContactLaws laws{LinearNormal{stiffness, Restitution{1.0}, false}, Frictionless{}, NoCohesion{}};
  const auto lost = [&](double steps) {
    const Scene scene = impacts(laws, false, false, steps);
    const auto end = static_cast<std::int64_t>(3.0 * steps);
    const Ran seen = ran_on_device(Precision::double_precision, Path::small, scene, end);
    EXPECT_NEAR(seen.after.kinetic, seen.before.kinetic, 1e-5 * seen.before.kinetic);
    return std::abs(seen.after.dissipated_normal) / seen.before.kinetic;
  };
  // A spring that sets in within a step is off by no more than (ω h)²/4 of the energy.
  for (const double steps : {32.3, 258.4}) EXPECT_LE(lost(steps), std::pow(std::numbers::pi / steps, 2) / 4);
}

/// What supports and fields have not given, and what it is measured by.
struct Leak {
  double momentum, scale;
};

Leak leak_of(const Scene& scene, const Ran& seen) {
  Vec3 change = Vec3::Zero();
  double scale = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double mass = mass_of(scene.particles[i], scene);
    change += mass * (seen.frame.velocity[i] - scene.particles[i].velocity);
    scale += mass * (seen.frame.velocity[i].norm() + scene.particles[i].velocity.norm());
  }
  return {(change - seen.after.support_impulse - seen.after.field_impulse).norm(), scale};
}

TEST(OnsetLedgerInDouble, OfAGasKeepsMomentum) {
  constexpr std::int64_t steps = 150;
  const Scene scene = scene_of("gas");
  const Ran seen = ran_on_device(Precision::double_precision, Path::zoned, scene, steps);
  EXPECT_GT(seen.after.dissipated_tangential, 0.0);
  // Gravity is rounded the same way at every step.
  const Leak leak = leak_of(scene, seen);
  EXPECT_LE(leak.momentum, steps * double_roundoff * leak.scale);
}

// One sphere overlaps the floor at the start. Spheres with several events in one step are many, and what each
// of those has done is measured by the velocities before and after all of them.
TEST(OnsetLedgerInDouble, OfAGasIsTheReferences) {
  constexpr std::int64_t steps = 100;
  const Scene scene = scene_of("gas");
  reference::ReferenceEngine reference;
  const Ran expected = ran(reference, scene, steps);
  const Ran seen = ran_on_device(Precision::double_precision, Path::zoned, scene, steps);
  const double bar = 1e-11 * expected.after.kinetic;
  for (std::size_t k = 0; k < energies.size(); ++k)
    EXPECT_NEAR(seen.after.*energies[k], expected.after.*energies[k], bar) << k;
  EXPECT_GT(expected.before.elastic, 0.0);
  EXPECT_EQ(expected.before.dissipated_normal + expected.before.dissipated_tangential, 0.0);
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    EXPECT_LE((seen.frame.velocity[i] - expected.frame.velocity[i]).norm(), 1e-11) << i;
}

class OnsetLedger : public ::testing::TestWithParam<Precision> {};

TEST_P(OnsetLedger, ChangesNoBitOfTheWay) {
  const Scene scene = scene_of("drum");
  const auto digest = [&](bool ledger) {
    return ran_on_device(GetParam(), Path::small, scene, 60, ledger).digest;
  };
  EXPECT_EQ(digest(true), digest(false));
}

// As in test_ledger.cpp: a rounding of the momentum a step, at random; Verlet's own error, at a quarter of
// the step.
TEST_P(OnsetLedger, MomentumAndEnergyBalance) {
  Scene scene = scene_of("drum");
  const Leak leak = leak_of(scene, ran_on_device(GetParam(), Path::small, scene, varied_steps));
  EXPECT_LE(leak.momentum, std::sqrt(varied_steps) * roundoff(GetParam()) * leak.scale);
  scene.run.step /= 4;
  const Ran seen = ran_on_device(GetParam(), Path::small, scene, 4 * varied_steps);
  EXPECT_LE(std::abs(seen.after.balance() - seen.before.balance()), 1e-5 * seen.before.kinetic);
  EXPECT_GT(seen.after.dissipated_normal, 0.05 * seen.before.kinetic);
}

GRAINPROOF_IN_EVERY_PRECISION(OnsetLedger);

}  // namespace
}  // namespace grainproof::opencl::testing
