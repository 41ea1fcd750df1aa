// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "comparisons/lammps/engine.hpp"
#include "comparisons/liggghts/engine.hpp"
#include "comparisons/metrics/collision.hpp"
#include "comparisons/metrics/resting.hpp"
#include "tests/comparisons/one_dimension.hpp"

namespace grainproof::test {
namespace {

constexpr double unit_roundoff = 0x1p-53;

/// One body of tests over both programs.
class Peer : public ::testing::TestWithParam<const char*> {
 protected:
  Peer() {
    if (std::string(GetParam()) == "lammps")
      engine_ = std::make_unique<LammpsEngine>();
    else
      engine_ = std::make_unique<LiggghtsEngine>();
  }
  Engine& peer() { return *engine_; }

 private:
  std::unique_ptr<Engine> engine_;
};

INSTANTIATE_TEST_SUITE_P(Both, Peer, ::testing::Values("lammps", "liggghts"),
                         [](const auto& own) { return std::string(own.param); });

void put_on_floor(Scene& scene, double height, Vec3 velocity) {
  scene.walls = {{"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}}};
  scene.domain.lower.z() = 0.0;
  scene.gravity = ConstantGravity{Vec3(0.0, 0.0, -9.81)};
  scene.particles = {particle(1, Vec3(0.0, 0.0, height), velocity)};
}

// the same additions in the same order agree to some roundings, 2e-16 of the speed each
TEST_P(Peer, ReboundFromAFixedSphereIsThatOfPlainVelocityVerlet) {
  double worst = 0.0;
  for (const double steps : {8.3, 16.0, 64.7, 256.0}) {
    const Scene scene = collision_with_fixed(steps, 0.4);
    const Observations seen = peer().observe(scene, {});
    ASSERT_EQ(seen.frames.size(), 2u);
    const Ball expected = bounced(scene);
    worst = std::max(worst, std::abs(seen.frames.back().velocity[1].x() / expected.v - 1.0));
    EXPECT_NEAR(seen.frames.back().position[1].x(), expected.x, 1e-12);
    EXPECT_EQ(seen.frames.back().position[0], Vec3(Vec3::Zero()));
  }
  RecordProperty("largest_relative_difference", std::to_string(worst / unit_roundoff) + " unit round-offs");
  EXPECT_LE(worst, 1e-12);
}

TEST_P(Peer, ReboundFromAWallIsThatOfPlainVelocityVerlet) {
  Scene scene = collision_with_fixed(32.6, 0.3);
  scene.walls = {{"side", 0, Plane{Vec3(0.05, 0.0, 0.0), Vec3::UnitX()}}};
  scene.particles.erase(scene.particles.begin());
  const Observations seen = peer().observe(scene, {});
  EXPECT_NEAR(seen.frames.back().velocity[0].x() / bounced(scene).v, 1.0, 1e-12);
}

TEST_P(Peer, FreeUnequalSpheresReboundWithTheReducedMass) {
  Scene scene = collision_with_fixed(200.0, 0.5);
  scene.particles[0].fixed = false;
  scene.particles[0].diameter = scene.particles[0].effect_diameter = 0.05;
  scene.particles[0].position.x() = 0.024;
  const Observations seen = peer().observe(scene, {});
  const Measured rebound = restitution(scene, seen);
  ASSERT_TRUE(rebound.exists()) << rebound.because;
  EXPECT_NEAR(rebound.value, restitution_value,
              5e-3);  // first order at 200 steps a contact, by the catalogue 1e-3 rms
  const Vec3 before = mass() * scene.particles[1].velocity;
  const Vec3 after = mass() * seen.frames.back().velocity[1] + mass(0.05) * seen.frames.back().velocity[0];
  EXPECT_NEAR((after - before).norm() / before.norm(), 0.0, 64 * unit_roundoff);
}

TEST_P(Peer, ContactWithoutTensionReboundsWithTheSameRestitution) {
  Scene scene = collision_with_fixed(2000.0, 0.5);
  scene.contacts.set(0, 0, {LinearNormal{stiffness, Restitution{restitution_value}, true}});
  const Measured rebound = restitution(scene, peer().observe(scene, {}));
  EXPECT_NEAR(rebound.value, restitution_value, 5e-4);  // first order at 2000 steps a contact
}

TEST_P(Peer, EveryPairHasTheDashpotOfItsOwnMasses) {
  Scene scene = collision_with_fixed(400.0, 0.5);
  scene.particles.clear();
  for (int k = 0; k < 3; ++k) {  // three pairs side by side: unequal, equal, and with a fixed partner
    const double small = k == 0 ? 0.06 : 0.1;
    const double y = -0.3 + 0.3 * k;
    scene.particles.push_back(particle(2 * k + 1, Vec3(0.0, y, 0.0), Vec3::Zero(), k == 2));
    scene.particles.push_back(
        particle(2 * k + 2, Vec3(0.0501 + 0.5 * small, y, 0.0), Vec3(-2.0, 0.0, 0.0), false, small));
  }
  const Observations seen = peer().observe(scene, {});
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<Vec3>& v = seen.frames.back().velocity;
    const double rebound = v[2 * k + 1].x() - v[2 * k].x();
    EXPECT_NEAR(rebound / 2.0, restitution_value, 2.5e-3) << k;  // first order at 400 steps a contact
  }
}

TEST_P(Peer, OverlapBecomesWeightOverStiffness) {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{restitution_value}}});
  put_on_floor(scene, 0.05, Vec3::Zero());
  run_for(scene, 3.0, 1.6e-4);
  const Measured overlap = resting_overlap(scene, peer().observe(scene, {}));
  ASSERT_TRUE(overlap.exists()) << overlap.because;
  // 0.05 m is held to 3.5e-18 m, 3.4e-14 of the overlap; a few such roundings a step
  EXPECT_NEAR(overlap.value / (mass() * 9.81 / stiffness), 1.0, 1e-12);
}

/// Slides on a floor at its resting overlap; returns how fast it is after 0.1 s.
double speed_after_sliding(Engine& engine, const FrictionLaw& friction) {
  Scene scene = scene_of({LinearNormal{stiffness, Restitution{restitution_value}}, friction});
  put_on_floor(scene, 0.05 - mass() * 9.81 / stiffness, Vec3(1.0, 0.0, 0.0));
  run_for(scene, 0.1, 1e-4);
  return engine.observe(scene, {}).frames.back().velocity[0].x();
}

TEST_P(Peer, DynamicFrictionSlowsByMuG) {
  // the starting overlap is right to 3.4e-14 of itself, and so is the normal force
  EXPECT_NEAR(speed_after_sliding(peer(), DynamicFriction{0.6}), 1.0 - 0.6 * 9.81 * 0.1, 1e-11);
}

TEST_P(Peer, StaticBranchCreepsAtTheRateOfItsLaw) {
  const double m = mass();
  const double rate = 1e5 * std::numbers::pi * std::sqrt(m / stiffness) / m;
  const double slow = 0.6 * 9.81 / rate;  // the slip at which the branches meet
  EXPECT_GT(slow, 0.0018);
  Scene scene =
      scene_of({LinearNormal{stiffness, Restitution{restitution_value}}, CollisionTimeFriction{0.6, 1e5}});
  put_on_floor(scene, 0.05 - m * 9.81 / stiffness, Vec3(0.5 * slow, 0.0, 0.0));
  run_for(scene, 2e-3, 1e-6);
  const double speed = peer().observe(scene, {}).frames.back().velocity[0].x();
  EXPECT_NEAR(speed / (0.5 * slow) / std::exp(-rate * 2e-3), 1.0,
              2e-3);  // half a step of lag: rate h/2 = 5e-4 a time constant
}

TEST_P(Peer, ParticleIsTakenAlongByTheStream) {
  Scene scene;
  scene.domain = {Vec3::Constant(-1.0), Vec3::Constant(20.0)};
  scene.materials = {{"light", 10.0}};
  scene.contacts = ContactTable(1);
  scene.particles = {particle(1, Vec3::Zero(), Vec3::Zero())};
  scene.flow = UniformFlow{1.93e-3, Vec3(1.0, 0.0, 0.0)};
  const double tau = 10.0 * 0.01 / (18.0 * 1.93e-3);
  run_for(scene, tau, tau / 1000.0);
  const double speed = peer().observe(scene, {}).frames.back().velocity[0].x();
  EXPECT_NEAR(speed, 1.0 - std::exp(-1.0), 1e-3);  // first order, h/τ = 1e-3
}

TEST_P(Peer, ManyScenesInOneProcessAreAsInOneEach) {
  std::vector<Scene> scenes;
  for (int i = 0; i < 300; ++i) scenes.push_back(collision_with_fixed(16.0 + 0.003 * i, (i + 0.5) / 300.0));
  const std::vector<Observations> seen = peer().observe_all(scenes, {});
  ASSERT_EQ(seen.size(), scenes.size());
  double spent = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(seen[i].frames.back().velocity[1].x() / bounced(scenes[i]).v, 1.0, 1e-12);
    spent += seen[i].wall_s;
  }
  RecordProperty("wall_ms_a_scene", std::to_string(1e3 * spent / static_cast<double>(seen.size())));
  const Observations alone = peer().observe(scenes[299], {});
  EXPECT_EQ(alone.frames.back().velocity[1], seen[299].frames.back().velocity[1]);
  EXPECT_EQ(alone.frames.back().time, seen[299].frames.back().time);
}

TEST_P(Peer, ComeAtTheStepAtOrAfterEachTimeAsked) {
  Scene scene = collision_with_fixed(10.0, 0.5);
  run_for(scene, 0.01, 0.0007);
  const Observations seen = peer().observe(scene, {{0.0, 0.001, 0.0014, 0.01}, false, false});
  std::vector<std::int64_t> steps;
  for (const Frame& frame : seen.frames) steps.push_back(frame.step);
  EXPECT_EQ(steps, (std::vector<std::int64_t>{0, 2, 15}));
  EXPECT_EQ(peer().observe(scene, {{}, true, false}).frames.size(), 16u);
}

TEST_P(Peer, ParticleThatLeavesTheDomainIsARunThatWentWrong) {
  Scene scene = collision_with_fixed(10.0, 0.5);
  run_for(scene, 2.0, 0.001);
  const Observations seen = peer().observe(scene, {});
  EXPECT_EQ(seen.outcome.status, Outcome::Status::went_wrong);
  EXPECT_EQ(seen.outcome.particles, std::vector<std::int64_t>{2});
}

TEST_P(Peer, RunThatBlowsUpIsAnOutcomeAndTheNextSceneGoesOn) {
  Scene unstable = scene_of({LinearNormal{stiffness, Damping{1e6}}});
  put_on_floor(unstable, 0.045, Vec3::Zero());
  run_for(unstable, 1.0, 0.01);  // far above 2 m/η = 2e-6 s
  const std::vector<Scene> scenes{unstable, collision_with_fixed(16.0, 0.5)};
  const std::vector<Observations> seen = peer().observe_all(scenes, {});
  EXPECT_EQ(seen[0].outcome.status, Outcome::Status::went_wrong);
  EXPECT_FALSE(seen[0].outcome.reason.empty());
  EXPECT_EQ(seen[1].outcome.status, Outcome::Status::completed);
}

TEST_P(Peer, SaysWhatItCannotExpress) {
  const auto because = [&](const auto& change, const Request& request = {}) {
    Scene scene = collision_with_fixed(10.0, 0.5);
    change(scene);
    const Support support = peer().supports(scene, request);
    return support ? std::string("supported") : support.because;
  };
  EXPECT_EQ(because([](Scene&) {}), "supported");
  EXPECT_EQ(because([](Scene& s) { s.run.integrator = Integrator::leapfrog_verlet; }), "supported");
  EXPECT_NE(because([](Scene& s) { s.run.integrator = Integrator::euler_trapezoid; }).find("velocity Verlet"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) {
              s.gravity = CentralGravity{1.0, Vec3::Zero()};
            }).find("towards a point"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) {
              s.flow = TaylorGreenFlow{1.0, 1.0, 1.0};
            }).find("Taylor-Green"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) {
              s.contacts.set(0, 0, {LinearNormal{1e5, Restitution{0.8}}, {}, LinearCohesion{1.0}});
            }).find("cohesion"),
            std::string::npos);
  EXPECT_NE(because([](Scene& s) {
              s.walls = {{"w", 0, Plane{Vec3(-0.5, 0, 0), Vec3(1, 1, 0).normalized()}}};
            }).find("along the axes"),
            std::string::npos);
  EXPECT_NE(because([](Scene&) {}, {{}, false, true}).find("ledger"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::test
