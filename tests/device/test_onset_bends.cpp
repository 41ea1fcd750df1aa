// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// (integrators.21): steps in which friction bends, the normal force passes zero, or a sliding contact ends,
// are the reference's on every path.
#include <random>

#include "device_fixture.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Impacts {
  double restitution, friction;
  bool no_tension = false;
};

constexpr Impacts all_impacts[] = {{0.3, 0.1}, {0.3, 0.5}, {0.3, 2.0}, {0.8, 0.1},       {0.8, 0.5},
                                   {0.8, 2.0}, {1.0, 0.1}, {1.0, 0.5}, {0.5, 0.5, true}, {0.3, 2.0, true}};

constexpr double steps_per_contact = 16.3;

/// Spinning spheres that meet each other and a wall at a slant, each at a phase of the step of its own.
Scene scene_of(const Impacts& impacts) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> even(-1.0, 1.0);
  const auto anyhow = [&](double size) {
    return Vec3(size * even(random), size * even(random), size * even(random));
  };
  Scene scene = empty_scene(impacts.restitution);
  scene.run.integrator = Integrator::onset_corrected;
  scene.rotation = true;
  const double ratio = impacts.restitution < 1.0 ? 0.5 : 0.0;
  scene.contacts.set(0, 0,
                     {LinearNormal{stiffness, Restitution{impacts.restitution}, impacts.no_tension},
                      HistoryFriction{impacts.friction, 0.37 * stiffness, ratio}, NoCohesion{}});
  scene.run.step =
      contact_time(sphere_mass(density, diameter) / 2, stiffness, impacts.restitution) / steps_per_contact;
  scene.walls = {{"wall", 0, Plane{Vec3(-0.9, 0, 0), Vec3::UnitX()}}};
  const auto add = [&](const Vec3& at, const Vec3& velocity) {
    scene.particles.push_back(sphere(static_cast<int>(scene.particles.size()), at, velocity));
    scene.particles.back().angular_velocity = anyhow(12.0);
  };
  for (int k = 0; k < 25; ++k) {
    const Vec3 at(0.2, -0.68 + 0.34 * (k % 5), -0.68 + 0.34 * (k / 5));
    const Vec3 slip(0.0, 1.5 * even(random), 1.5 * even(random)), way = slip - Vec3::UnitX();
    const double ahead = scene.run.step * (1.5 + 0.5 * even(random));
    const Vec3 normal = Vec3(1.0, 0.3 * even(random), 0.3 * even(random)).normalized();
    add(at, slip / 2 - normal);
    add(at - normal * (diameter + 2 * ahead), normal - slip / 2);
    add(Vec3(-0.9 + diameter / 2, at.y(), at.z()) - ahead * way, way);
  }
  return scene;
}

struct Ended {
  Frame frame;
  Ledger ledger;
};

Ended ended(SteppingEngine& engine, const Scene& scene, bool ledger) {
  Request request;
  request.ledger = ledger;
  const auto run = engine.start(scene, request);
  run->advance(static_cast<std::int64_t>(2.5 * steps_per_contact));
  return {run->frame(), ledger ? run->ledger() : Ledger{}};
}

Ended on_device(const Scene& scene, Path path, bool ledger) {
  EngineOptions options = options_for(Precision::double_precision);
  options.path = path;
  OpenClEngine engine(options);
  return ended(engine, scene, ledger);
}

void expect_same(const Frame& seen, const Frame& expected, const Impacts& impacts) {
  double linear = 0.0, angular = 0.0;
  for (std::size_t i = 0; i < expected.velocity.size(); ++i) {
    linear = std::max(linear, (seen.velocity[i] - expected.velocity[i]).norm());
    angular =
        std::max(angular, (seen.angular_velocity[i] - expected.angular_velocity[i]).norm() * diameter / 2);
  }
  EXPECT_LE(linear, 1e-11) << impacts.restitution << ' ' << impacts.friction;
  EXPECT_LE(angular, 1e-11) << impacts.restitution << ' ' << impacts.friction;
}

class OnsetBends : public ::testing::TestWithParam<Path> {};

TEST_P(OnsetBends, AreTheReferences) {
  for (const Impacts& impacts : all_impacts) {
    const Scene scene = scene_of(impacts);
    reference::ReferenceEngine reference;
    const Ended expected = ended(reference, scene, false);
    expect_same(on_device(scene, GetParam(), false).frame, expected.frame, impacts);
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, OnsetBends, ::testing::Values(Path::zoned, Path::dense),
                         [](const ::testing::TestParamInfo<Path>& param) {
                           return std::string(param.param == Path::dense ? "dense" : "zoned");
                         });

// What an event does to the slip is booked as lost to friction, on both.
TEST(OnsetBendsInDouble, AreBookedAsTheReferenceDoes) {
  for (const Impacts& impacts : all_impacts) {
    const Scene scene = scene_of(impacts);
    reference::ReferenceEngine reference;
    const Ended expected = ended(reference, scene, true), seen = on_device(scene, Path::zoned, true);
    const double bar = 1e-11 * expected.ledger.kinetic;
    EXPECT_NEAR(seen.ledger.dissipated_tangential, expected.ledger.dissipated_tangential, bar);
    EXPECT_NEAR(seen.ledger.dissipated_normal, expected.ledger.dissipated_normal, bar);
    EXPECT_NEAR(seen.ledger.elastic, expected.ledger.elastic, bar);
    EXPECT_LE((seen.ledger.support_impulse - expected.ledger.support_impulse).norm(),
              1e-11 * expected.ledger.support_impulse.norm());
  }
}

}  // namespace
}  // namespace grainproof::opencl::testing
