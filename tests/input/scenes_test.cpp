// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <sstream>

#include "input/read_case.hpp"
#include "tests/input/example.hpp"
#include "tests/input/scene_files.hpp"

namespace grainproof {
namespace {

class SceneFile : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(SceneFile, IsCompleteAndClaimsSomething) {
  const Case read = read_case(GetParam());
  EXPECT_EQ(read.name, GetParam().stem());
  EXPECT_FALSE(read.title.empty());
  EXPECT_FALSE(read.expectations.empty());
  ASSERT_TRUE(!read.scenes.empty() || !read.refused.empty());
  for (const ResolvedScene& resolved : read.scenes) {
    const RunSettings& run = resolved.scene.run;
    EXPECT_GT(run.step, 0.0);
    EXPECT_EQ(run.sample_times.front(), 0.0);
    EXPECT_EQ(run.sample_times.back(), run.end);
    EXPECT_TRUE(std::is_sorted(run.sample_times.begin(), run.sample_times.end(), std::less_equal<>()));
    const auto& particles = resolved.scene.particles;
    EXPECT_TRUE(std::is_sorted(particles.begin(), particles.end(),
                               [](const Particle& a, const Particle& b) { return a.id <= b.id; }));
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneFile, ::testing::ValuesIn(scene_files()), name_of_file);

TEST(Scenes, TheExampleInTheDocumentationIsRead) {
  std::ostringstream document;
  document << std::ifstream("docs/scene.md").rdbuf();
  const std::string text = document.str();
  const std::string opening = "```toml\n";
  const std::size_t begin = text.find(opening) + opening.size();
  ASSERT_GT(begin, opening.size());
  const Case read = read_case_text(text.substr(begin, text.find("```", begin) - begin), "docs/scene.md");
  EXPECT_EQ(read.scenes.at(0).scene.particles.size(), 2u);
}

TEST(Scenes, WithoutParticlesThereIsASceneAllTheSame) {
  const std::string text =
      "schema = 1\n[run]\nend = 1.0\nstep = 0.1\n[domain]\nlower = [0, 0, 0]\nupper = [1, 1, 1]\n";
  EXPECT_TRUE(read_case_text(text, "empty.toml").scenes.at(0).scene.particles.empty());
}

TEST(Scenes, NormalCollisionExpandsToEveryStepPhaseAndIntegratorInWellUnderASecond) {
  const auto began = std::chrono::steady_clock::now();
  const Case read = read_case("scenes/normal_collision.toml");
  EXPECT_EQ(read.scenes.size(), 8u * 256u * 3u);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(500));
}

TEST(Scenes, SettlingStepIsASixtyFourthOfTheContact) {
  const Case read = read_case("scenes/settling.toml");
  ASSERT_EQ(read.scenes.size(), 3u);
  // π/sqrt(k/m − (η/2m)²) for m = 1.0471976 kg, k = 1e5 N/m and ε = 0.8, worked out by hand.
  EXPECT_NEAR(read.scenes[0].scene.run.step, 0.01019194 / 64, 1e-10);
}

TEST(Scenes, TheSkinMayBeLeftToASearch) {
  const Case read = read_text(with(example, "end = 0.01", "skin = \"auto\"\nend = 0.01"));
  EXPECT_EQ(read.scenes.at(0).scene.run.skin, RunSettings::searched_skin);
}

TEST(Scenes, BoxOf1000TakesAHundredThousandSteps) {
  const Case read = read_case("scenes/box_1000.toml");
  const Scene& scene = read.scenes.at(0).scene;
  EXPECT_EQ(scene.particles.size(), 1000u);
  EXPECT_EQ(scene.walls.size(), 6u);
  EXPECT_NEAR(scene.run.end / scene.run.step, 1e5, 1e-6);
}

TEST(Scenes, AWalledDomainHasItsSixFacesAsPlanesThatFaceInwards) {
  const Scene scene = read_case("scenes/box_1000.toml").scenes.at(0).scene;
  const Vec3 middle = 0.5 * (scene.domain.lower + scene.domain.upper);
  for (const Wall& wall : scene.walls) {
    const auto& plane = std::get<Plane>(wall.shape);
    EXPECT_NEAR((middle - plane.point).dot(plane.normal), 0.075, 1e-15) << wall.name;
  }
  EXPECT_EQ(scene.walls[4].name, "domain:z-lower");
}

}  // namespace
}  // namespace grainproof
