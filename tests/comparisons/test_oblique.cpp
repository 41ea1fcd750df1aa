// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "comparisons/lammps/engine.hpp"
#include "comparisons/liggghts/engine.hpp"
#include "tests/comparisons/oblique.hpp"

/// Contacts with history friction: each peer against its law as docs/laws/history.md has it.
namespace grainproof::test {
namespace {

constexpr HistoryFriction as_lammps{
    0.35, 3e4, 0.5, CoulombLimit::spring_and_dashpot, TorqueArm::radius, SpringTurn::project};
constexpr HistoryFriction as_liggghts{
    0.35, 3e4, 0.5, CoulombLimit::spring, TorqueArm::overlap, SpringTurn::project};

// The same sums in another order: some roundings of 1e-16 a step over 100 steps. A wrong arm is off by 1e-3,
// a rescaled spring by 1e-9 (measured).
constexpr double same = 1e-12;

Vec3 random_vector(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> part(-size, size);
  return {part(random), part(random), part(random)};
}

/// Two spheres of unequal size that meet obliquely, spinning, after less than a step; sticks or slides.
Scene random_pair(const ContactLaws& laws, unsigned seed) {
  std::mt19937 random(seed);
  Scene scene = scene_of(laws);
  scene.rotation = true;
  run_for(scene, 0.02, 1e-4);
  const Vec3 n = (Vec3(1.0, 0.0, 0.0) + random_vector(random, 0.5)).normalized();
  const Vec3 u = random_vector(random, 1.0) - 2.0 * n;
  scene.particles = {particle(1, Vec3::Zero(), random_vector(random, 0.2), false, 0.12),
                     particle(2, Vec3::Zero(), Vec3::Zero(), false, 0.088)};
  scene.particles[1].velocity = scene.particles[0].velocity + u;
  scene.particles[1].position = (0.104 - 0.3 * u.dot(n) * scene.run.step) * n;
  for (Particle& body : scene.particles) body.angular_velocity = random_vector(random, 30.0);
  return scene;
}

Scene random_wall(const ContactLaws& laws, unsigned seed) {
  Scene scene = random_pair(laws, seed);
  scene.walls = {{"side", 0, Plane{Vec3::Zero(), Vec3::UnitX()}}};
  scene.particles.erase(scene.particles.begin());
  Particle& body = scene.particles.front();
  body.velocity.x() = -2.0;
  body.position = Vec3(0.044 + 0.3 * 2.0 * scene.run.step, 0.1, -0.05);
  return scene;
}

/// Largest difference from the loop of this folder over random contacts: of speeds over 2 m/s, of spins
/// over 30 rad/s.
double largest_difference(Engine& engine, const ContactLaws& laws,
                          Scene (*scene_with)(const ContactLaws&, unsigned), unsigned count = 200) {
  std::vector<Scene> scenes;
  for (unsigned seed = 0; seed < count; ++seed) scenes.push_back(scene_with(laws, seed));
  const Support support = engine.supports(scenes.front(), {});
  EXPECT_TRUE(support.yes) << support.because;
  if (!support) return 1.0;
  const std::vector<Observations> all = engine.observe_all(scenes, {});
  double largest = 0.0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Frame expected = Oblique(scenes[k]).run();
    const Frame& seen = all[k].frames.back();
    for (std::size_t i = 0; i < seen.velocity.size(); ++i) {
      largest = std::max(largest, (seen.velocity[i] - expected.velocity[i]).norm() / 2.0);
      largest = std::max(largest, (seen.angular_velocity[i] - expected.angular_velocity[i]).norm() / 30.0);
    }
  }
  ::testing::Test::RecordProperty("largest_difference", std::to_string(largest * 1e15) + "e-15");
  return largest;
}

ContactLaws linear(const HistoryFriction& friction, double restitution = 0.8) {
  return {LinearNormal{stiffness, Restitution{restitution}}, friction};
}

ContactLaws hertz(HistoryFriction friction, double restitution, double damping_ratio) {
  friction.damping_ratio = damping_ratio;
  return {HertzNormal{Restitution{restitution}}, friction};
}

template <Scene (*scene_with)(const ContactLaws&, unsigned)>
Scene elastic(const ContactLaws& laws, unsigned seed) {
  Scene scene = scene_with(laws, seed);
  scene.materials[0].elasticity = Elasticity{2e7, 0.3};
  return scene;
}

TEST(LammpsOblique, ThousandPairsAreIntegratedAsTheirLawIsWritten) {
  LammpsEngine lammps;
  EXPECT_LE(largest_difference(lammps, linear(as_lammps), random_pair, 1000), same);
}

TEST(LammpsOblique, WallContactIsIntegratedAsItsLawIsWritten) {
  LammpsEngine lammps;
  EXPECT_LE(largest_difference(lammps, linear(as_lammps), random_wall), same);
}

TEST(LammpsOblique, ElasticHertzPairsAndWallsAreIntegratedAsTheirLawIsWritten) {
  LammpsEngine lammps;
  EXPECT_LE(largest_difference(lammps, hertz(as_lammps, 1.0, 0.0), elastic<random_pair>), same);
  EXPECT_LE(largest_difference(lammps, hertz(as_lammps, 1.0, 0.0), elastic<random_wall>), same);
}

TEST(LiggghtsOblique, ThousandPairsAreIntegratedAsTheirLawIsWritten) {
  LiggghtsEngine liggghts;
  EXPECT_LE(largest_difference(liggghts, linear(as_liggghts), random_pair, 1000), same);
}

TEST(LiggghtsOblique, WallContactIsIntegratedAsItsLawIsWritten) {
  LiggghtsEngine liggghts;
  EXPECT_LE(largest_difference(liggghts, linear(as_liggghts), random_wall), same);
}

TEST(LiggghtsOblique, HertzPairsAreIntegratedAsTheirLawIsWritten) {
  LiggghtsEngine liggghts;
  EXPECT_LE(largest_difference(liggghts, hertz(as_liggghts, 0.7, 1.0), elastic<random_pair>), same);
  EXPECT_LE(largest_difference(liggghts, hertz(as_liggghts, 0.7, 0.0), elastic<random_pair>), same);
}

TEST(LiggghtsOblique, HertzWallContactsAreIntegratedAsTheirLawIsWritten) {
  LiggghtsEngine liggghts;
  EXPECT_LE(largest_difference(liggghts, hertz(as_liggghts, 0.7, 1.0), elastic<random_wall>), same);
}

TEST(LiggghtsOblique, RollingResistanceIsIntegratedAsItsLawsAreWritten) {
  LiggghtsEngine liggghts;
  for (const RollingLaw& rolling : {RollingLaw(ConstantTorqueRolling{0.1}), RollingLaw(SpringRolling{0.1}),
                                    RollingLaw(SpringRolling{0.01})}) {
    ContactLaws laws = linear(as_liggghts);
    laws.rolling = rolling;
    EXPECT_LE(largest_difference(liggghts, laws, random_pair, 50), same);
    EXPECT_LE(largest_difference(liggghts, laws, random_wall, 50), same);
    laws = hertz(as_liggghts, 0.7, 1.0);
    laws.rolling = rolling;
    EXPECT_LE(largest_difference(liggghts, laws, elastic<random_pair>, 50), same);
    EXPECT_LE(largest_difference(liggghts, laws, elastic<random_wall>, 50), same);
  }
}

TEST(Oblique, DashpotsGivenAsShareOfTheCriticalOneAreThose) {
  LammpsEngine lammps;
  LiggghtsEngine liggghts;
  const LinearNormal normal{stiffness, DampingRatio{0.1}};
  EXPECT_LE(largest_difference(lammps, {normal, as_lammps}, random_pair, 30), same);
  EXPECT_LE(largest_difference(liggghts, {normal, as_liggghts}, random_wall, 30), same);
  HistoryFriction damped = as_liggghts;
  damped.damping_ratio = 1.0;
  const ContactLaws share{HertzNormal{DampingRatio{0.1}}, damped};
  EXPECT_LE(largest_difference(liggghts, share, elastic<random_pair>, 30), same);
}

TEST(Oblique, FrictionHasTheNormalForceThatIsLeftWithoutTension) {
  LammpsEngine lammps;
  LiggghtsEngine liggghts;
  const LinearNormal normal{stiffness, Damping{120.0}, true};
  EXPECT_LE(largest_difference(lammps, {normal, as_lammps}, random_pair, 30), same);
  EXPECT_LE(largest_difference(lammps, {normal, as_lammps}, random_wall, 30), same);
  EXPECT_LE(largest_difference(liggghts, {normal, as_liggghts}, random_pair, 30), same);
  EXPECT_LE(largest_difference(liggghts, {normal, as_liggghts}, random_wall, 30), same);
}

/// A free pair, and one with a fixed partner: two dashpots, so two styles of a hybrid in LAMMPS.
void expect_both_pairs(Engine& engine, const HistoryFriction& friction) {
  Scene both = random_pair(linear(friction), 3);
  Scene held = random_pair(linear(friction), 4);
  Particle& still = held.particles[0];
  held.particles[1].velocity -= still.velocity;
  still = particle(3, still.position, Vec3::Zero(), true, still.diameter);
  held.particles[1].id = 4;
  for (Particle& body : held.particles) body.position.y() += 0.3;
  const Frame free_pair = Oblique(both).run();
  const Frame held_pair = Oblique(held).run();
  both.particles.insert(both.particles.end(), held.particles.begin(), held.particles.end());
  const Frame seen = engine.observe(both, {}).frames.back();
  EXPECT_LE((seen.angular_velocity[0] - free_pair.angular_velocity[0]).norm() / 30.0, same);
  EXPECT_LE((seen.velocity[1] - free_pair.velocity[1]).norm() / 2.0, same);
  EXPECT_LE((seen.velocity[3] - held_pair.velocity[1]).norm() / 2.0, same);
  EXPECT_LE((seen.angular_velocity[3] - held_pair.angular_velocity[1]).norm() / 30.0, same);
  EXPECT_EQ(seen.angular_velocity[2], Vec3(Vec3::Zero()));
}

TEST(Oblique, PairsOfOneSceneKeepTheirOwnDashpotsAndSprings) {
  LammpsEngine lammps;
  LiggghtsEngine liggghts;
  expect_both_pairs(lammps, as_lammps);
  expect_both_pairs(liggghts, as_liggghts);
}

TEST(Oblique, SceneWithoutRotationLeavesSpinsAlone) {
  Scene scene = random_pair(linear(as_lammps), 1);
  scene.rotation = false;
  for (Particle& body : scene.particles) body.angular_velocity.setZero();
  const Frame expected = Oblique(scene).run();
  LammpsEngine lammps;
  const Frame seen = lammps.observe(scene, {}).frames.back();
  EXPECT_TRUE(seen.angular_velocity.empty());
  EXPECT_LE((seen.velocity[1] - expected.velocity[1]).norm() / 2.0, same);
}

std::string because(const Engine& engine, const HistoryFriction& friction, double restitution = 0.8) {
  return engine.supports(random_pair(linear(friction, restitution), 1), {}).because;
}

TEST(Oblique, VariantsThatAreNotTheProgramsOwnAreRefusedWithTheReason) {
  const LammpsEngine lammps;
  const LiggghtsEngine liggghts;
  EXPECT_NE(because(lammps, as_liggghts).find("limit on spring and dashpot"), std::string::npos);
  EXPECT_NE(because(liggghts, as_lammps).find("limit on the spring alone"), std::string::npos);
  HistoryFriction other = as_lammps;
  other.arm = TorqueArm::overlap;
  EXPECT_NE(because(lammps, other).find("at their radius"), std::string::npos);
  other = as_liggghts;
  other.arm = TorqueArm::radius;
  EXPECT_NE(because(liggghts, other).find("less half the overlap"), std::string::npos);
  other.turn = SpringTurn::project_and_rescale;
  EXPECT_NE(because(liggghts, other).find("by project only"), std::string::npos);
  EXPECT_NE(because(lammps, other).find("by project only"), std::string::npos);
  other = as_lammps;
  other.damping_ratio = 0.0;
  other.limit = CoulombLimit::spring;  // without a dashpot both limits are one
  EXPECT_EQ(because(lammps, other), "");
}

TEST(Oblique, HertzContactsThatLiggghtsDoesNotHaveAreRefusedWithTheReason) {
  const LiggghtsEngine liggghts;
  const auto answer = [&](const ContactLaws& laws, double poisson_ratio = 0.3) {
    Scene scene = elastic<random_pair>(laws, 1);
    scene.materials[0].elasticity->poisson_ratio = poisson_ratio;
    return liggghts.supports(scene, {}).because;
  };
  EXPECT_EQ(answer(hertz(as_liggghts, 0.7, 1.0), 0.5), "");
  EXPECT_NE(answer(hertz(as_liggghts, 0.7, 0.5)).find("damping ratio 1 or 0"), std::string::npos);
  EXPECT_NE(answer(hertz(as_liggghts, 0.05, 1.0)).find("0.05 or less"), std::string::npos);
  EXPECT_NE(answer(hertz(as_liggghts, 0.7, 1.0), -0.1).find("Poisson"), std::string::npos);
  EXPECT_NE(answer({HertzNormal{Restitution{0.7}}, DynamicFriction{0.3}}).find("history friction only"),
            std::string::npos);
}

}  // namespace
}  // namespace grainproof::test
