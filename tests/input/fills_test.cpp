// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

/// A scene whose only particles come from `fill`, with what else its table holds.
std::string filled(const std::string& table, const std::string& boundary = "open") {
  return R"(schema = 1
[run]
end = 1.0
step = 1e-4
[domain]
lower = [0.0, 0.0, 0.0]
upper = [1.0, 1.0, 1.0]
boundary = [")" +
         boundary + R"(", "open", "open"]
[material.glass]
density = 2000.0
[[contact]]
between = ["glass", "glass"]
normal = { law = "linear", stiffness = 1e5, restitution = 0.8 }
[[particles]]
material = "glass"
)" + table +
         "\n";
}

std::vector<Particle> particles_of(const std::string& table, const std::string& boundary = "open") {
  return read_text(filled(table, boundary)).scenes.at(0).scene.particles;
}

constexpr const char* thousand = "diameter = 0.05\nfill = { kind = \"random\", count = 1000, seed = 1 }";

double closest(const std::vector<Particle>& particles, double period) {
  double least = 1.0;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 apart = particles[i].position - particles[j].position;
      apart[0] -= period * std::round(apart[0] / period);
      least = std::min(least, apart.norm());
    }
  return least;
}

TEST(Fills, LatticeRunsThroughXFirstFromItsOrigin) {
  const auto particles = particles_of(
      "diameter = 0.1\nfill = { kind = \"lattice\", counts = [2, 3, 4], origin = [0.1, 0.2, 0.3], spacing = "
      "0.15 }");
  ASSERT_EQ(particles.size(), 24u);
  EXPECT_EQ(particles[0].position, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(particles[1].position, Vec3(0.1 + 0.15, 0.2, 0.3));
  EXPECT_EQ(particles[2].position, Vec3(0.1, 0.2 + 0.15, 0.3));
  EXPECT_EQ(particles[6].position, Vec3(0.1, 0.2, 0.3 + 0.15));
  EXPECT_EQ(particles[23].id, 24);
}

TEST(Fills, LatticeJitterStaysWithinItsAmplitude) {
  const std::string table =
      "diameter = 0.1\nfill = { kind = \"lattice\", counts = [5, 5, 5], origin = [0.1, 0.1, 0.1], spacing = "
      "0.15, ";
  const auto still = particles_of(table + "jitter = 0.0, seed = 1 }");
  const auto jittered = particles_of(table + "jitter = 0.02, seed = 1 }");
  double largest = 0.0;
  for (std::size_t i = 0; i < still.size(); ++i)
    largest = std::max(largest, (still[i].position - jittered[i].position).cwiseAbs().maxCoeff());
  EXPECT_LE(largest, 0.02);
  EXPECT_GT(largest, 0.015);
}

TEST(Fills, RandomParticlesTouchNothing) {
  const auto particles = particles_of(thousand);
  ASSERT_EQ(particles.size(), 1000u);
  EXPECT_GE(closest(particles, 1e300), 0.05);
  for (const Particle& particle : particles) {
    EXPECT_GE(particle.position.minCoeff(), 0.025);
    EXPECT_LE(particle.position.maxCoeff(), 0.975);
  }
}

TEST(Fills, RandomParticlesTouchNothingAcrossAPeriod) {
  const auto particles = particles_of(thousand, "periodic");
  EXPECT_GE(closest(particles, 1.0), 0.05);
  const auto beyond = [](const Particle& particle) { return particle.position[0] < 0.02; };
  EXPECT_TRUE(std::any_of(particles.begin(), particles.end(), beyond));  // periodic faces are no walls
}

TEST(Fills, RandomParticlesKeepTheirGapAndAvoidWhatStandsThere) {
  const auto particles = particles_of(
      "diameter = 0.3\nfixed = true\npositions = [[0.5, 0.5, 0.5]]\n[[particles]]\nmaterial = \"glass\"\n"
      "diameter = 0.05\nfill = { kind = \"random\", count = 300, seed = 5, gap = 0.02 }");
  ASSERT_EQ(particles.size(), 301u);
  for (std::size_t i = 1; i < particles.size(); ++i)
    EXPECT_GE((particles[i].position - particles[0].position).norm(), 0.195);
  EXPECT_GE(closest({particles.begin() + 1, particles.end()}, 1e300), 0.07);
}

TEST(Fills, TheSameSeedGivesTheSamePlacesAndAnotherSeedOthers) {
  const auto first = particles_of(thousand);
  EXPECT_EQ(first[999].position, particles_of(thousand)[999].position);
  EXPECT_NE(first[999].position, particles_of(with(thousand, "seed = 1", "seed = 2"))[999].position);
}

TEST(Fills, RandomNumbersAreThoseOfTheStandardsEngine) {
  // The 10000th draw of a mt19937_64 seeded with 5489 is 9981545732273789042 (ISO C++, [rand.predef]).
  const std::string text = filled(
      "diameter = 1e-9\nfill = { kind = \"random\", count = 3334, seed = 5489, lower = [0, 0, 0], upper = "
      "[1, 1, 1] }");
  const Case read = read_text(text, {.force = true});
  EXPECT_EQ(read.scenes.at(0).scene.particles[3333].position[0],
            static_cast<double>(9981545732273789042u >> 11) * 0x1p-53);
}

TEST(Fills, RandomSpeedsFillTheirRange) {
  const auto particles =
      particles_of(std::string(thousand) + "\nvelocity = [1.0, 0.0, 0.0]\nrandom_speed = 0.5\nseed = 9");
  Vec3 least = Vec3::Constant(9.0);
  Vec3 most = Vec3::Constant(-9.0);
  for (const Particle& particle : particles) {
    least = least.cwiseMin(particle.velocity);
    most = most.cwiseMax(particle.velocity);
  }
  // 1000 even draws miss the outer hundredth of a range with probability 0.99^1000 = 4e-5.
  EXPECT_TRUE((least - Vec3(0.5, -0.5, -0.5)).cwiseAbs().maxCoeff() < 0.01) << least;
  EXPECT_TRUE((most - Vec3(1.5, 0.5, 0.5)).cwiseAbs().maxCoeff() < 0.01) << most;
}

TEST(Fills, WhatDoesNotFitIsRefusedWithWhatDid) {
  const std::string message =
      refusal_of(filled("diameter = 0.4\nfill = { kind = \"random\", count = 50, seed = 1 }"));
  EXPECT_NE(message.find("found 50 particles that don't fit"), std::string::npos) << message;
}

TEST(Fills, MoreParticlesThanAreHandledAreRefusedBeforeTheyAreMade) {
  const std::string lattice = filled(
      "diameter = 1e-6\nfill = { kind = \"lattice\", counts = [4000, 4000, 4000], origin = [0.1, 0.1, 0.1] "
      "}");
  EXPECT_NE(
      refusal_of(lattice).find("found a lattice of [4000, 4000, 4000]; expected at most 20000000 particles"),
      std::string::npos)
      << refusal_of(lattice);
  const std::string random =
      filled("diameter = 1e-6\nfill = { kind = \"random\", count = 4000000000, seed = 1 }");
  EXPECT_NE(refusal_of(random).find("from 1 to 20000000"), std::string::npos) << refusal_of(random);
}

/// A CSV file beside the scene, gone at the end.
class CsvFill : public ::testing::Test {
 protected:
  CsvFill() { std::filesystem::create_directories(folder_); }
  ~CsvFill() override { std::filesystem::remove_all(folder_); }

  std::string refusal() const {
    try {
      read();
    } catch (const InputRefused& refused) {
      return refused.what();
    }
    return "";
  }

  Case read() const {
    return read_case_text(filled("diameter = 0.1\nfill = { kind = \"file\", path = \"grains.csv\" }"),
                          folder_ / "scene.toml");
  }

  void write(const std::string& text) const { std::ofstream(folder_ / "grains.csv") << text; }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() /
      ("grainproof-" + std::to_string(getpid()) + "-" +
       std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(CsvFill, GivesPlacesVelocitiesAndIds) {
  write("id, x, y, z, vx, vy, vz\n7, 0.1, 0.2, 0.3, 1, 2, 3\n\n3, 0.5, 0.6, 0.7, 4, 5, 6\n");
  const auto particles = read().scenes.at(0).scene.particles;
  ASSERT_EQ(particles.size(), 2u);
  EXPECT_EQ(particles[0].id, 3);
  EXPECT_EQ(particles[0].position, Vec3(0.5, 0.6, 0.7));
  EXPECT_EQ(particles[1].velocity, Vec3(1, 2, 3));
}

TEST_F(CsvFill, NamesItsOwnLines) {
  const std::string file = (folder_ / "grains.csv").string();
  write("x,y,z\n0.1,0.1,0.1\n0.2,oops,0.2\n");
  EXPECT_EQ(refusal(), file + ":3:2: found \"oops\" in column \"y\"; expected a finite number");
  write("x,y,z\n0.1,0.1\n");
  EXPECT_EQ(refusal(), file + ":2:1: found 2 values; expected 3, as in the header");
  write("x,y,w\n0.1,0.1,0.1\n");
  EXPECT_TRUE(refusal().starts_with(file + ":1:3: found unknown column \"w\"")) << refusal();
  write("x,y\n0.1,0.1\n");
  EXPECT_TRUE(refusal().starts_with(file + ":1:1: found no column \"z\"")) << refusal();
  write("x,y,z,vx,vy\n0.1,0.1,0.1,1,1\n");
  EXPECT_TRUE(refusal().starts_with(file + ":1:1: found a velocity with a component missing")) << refusal();
  write("x,y,z,id\n0.1,0.1,0.1,1.5\n");
  EXPECT_TRUE(refusal().starts_with(file + ":2:4: found id 1.5")) << refusal();
}

TEST_F(CsvFill, IsRefusedWhereItIsMissingOrEmpty) {
  EXPECT_NE(refusal().find("expected a file that can be read"), std::string::npos) << refusal();
  write("x,y,z\n");
  EXPECT_NE(refusal().find("without particles"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace grainproof
