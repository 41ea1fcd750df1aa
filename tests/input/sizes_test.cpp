// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <fstream>

#include "tests/input/refusals.hpp"

namespace grainproof {
namespace {

const std::string pair = "diameter = 0.1\npositions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]";
const std::string moving =
    "positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]\nvelocities = [[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]";

std::string cloud(const std::string& diameter, const std::string& more = "") {
  return with(with(example, moving, "fill = { kind = \"random\", count = 200, seed = 3 }" + more),
              "diameter = 0.1\nfill", "diameter = " + diameter + "\nfill");
}

std::vector<double> sizes_of(const std::string& text) {
  std::vector<double> sizes;
  const auto particles = read_text(text).scenes.at(0).scene.particles;
  for (const Particle& particle : particles)
    if (!particle.fixed) sizes.push_back(particle.diameter);
  return sizes;
}

TEST(Sizes, AreGivenOneForEachPosition) {
  const std::string text =
      with(example, pair, "diameters = [0.1, 0.2]\npositions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]");
  const auto particles = read_text(text).scenes.at(0).scene.particles;
  EXPECT_EQ(particles[1].diameter, 0.1);
  EXPECT_EQ(particles[2].diameter, 0.2);
  EXPECT_EQ(particles[2].effect_diameter, 0.2);
}

TEST(Sizes, OfAFillAreSpreadEvenlyAndTouchNothing) {
  const std::string text = cloud("{ uniform = [0.02, 0.06], seed = 1 }");
  const auto sizes = sizes_of(text);
  ASSERT_EQ(sizes.size(), 200u);
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  EXPECT_GE(*least, 0.02);
  EXPECT_LE(*most, 0.06);
  double mean = 0.0;
  for (const double size : sizes) mean += size / 200.0;
  EXPECT_NEAR(mean, 0.04, 4.0 * 0.04 / std::sqrt(12.0 * 200.0));  // four standard errors
  const auto particles = read_text(text).scenes.at(0).scene.particles;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE((particles[i].position - particles[j].position).norm(),
                0.5 * (particles[i].diameter + particles[j].diameter));
}

TEST(Sizes, FollowTheirOwnSeed) {
  const auto one = sizes_of(cloud("{ uniform = [0.02, 0.06], seed = 1 }"));
  EXPECT_EQ(one, sizes_of(cloud("{ uniform = [0.02, 0.06], seed = 1 }")));
  EXPECT_NE(one, sizes_of(cloud("{ uniform = [0.02, 0.06], seed = 2 }")));
}

TEST(Sizes, ALatticeIsAsWideAsItsLargest) {
  const std::string text = with(
      with(example, moving, "fill = { kind = \"lattice\", counts = [3, 3, 1], origin = [0.3, 0.3, 0.3] }"),
      "diameter = 0.1\nfill", "diameter = { uniform = [0.02, 0.06], seed = 1 }\nfill");
  const auto particles = read_text(text).scenes.at(0).scene.particles;
  EXPECT_NEAR(particles[2].position.x() - particles[1].position.x(), 0.06, 1e-16);
}

TEST(Sizes, AFileMayHoldDiametersAndSpins) {
  std::ofstream("sizes_test.csv") << "x,y,z,d,wx,wy,wz\n0.3,0.3,0.3,0.04,1,2,3\n0.6,0.3,0.3,0.08,0,0,0\n";
  const std::string text =
      with(with(example, moving, "fill = { kind = \"file\", path = \"sizes_test.csv\" }"),
           "diameter = 0.1\nfill", "fill");
  const std::string turning = with(text, "[field]", "[bodies]\nrotation = true\n[field]");
  const auto particles = read_text(turning).scenes.at(0).scene.particles;
  EXPECT_EQ(particles[1].diameter, 0.04);
  EXPECT_EQ(particles[2].diameter, 0.08);
  EXPECT_EQ(particles[1].angular_velocity, Vec3(1, 2, 3));
  EXPECT_NE(refusal_of(text).find("spins in a scene without rotation"), std::string::npos);
  EXPECT_NE(refusal_of(with(turning, "fill =", "diameter = 0.1\nfill =")).find("the file has its own"),
            std::string::npos);
  std::remove("sizes_test.csv");
}

TEST(Seeds, EverySampleAddsOneToEverySeedOfTheScene) {
  const std::string swept = cloud("{ uniform = [0.02, 0.06], seed = 1 }") + "\n[sweep]\nseeds = 3\n";
  const Case read = read_text(swept);
  ASSERT_EQ(read.scenes.size(), 3u);
  const std::string next =
      with(with(cloud("{ uniform = [0.02, 0.06], seed = 1 }"), "seed = 1 }", "seed = 2 }"), "seed = 3 }",
           "seed = 4 }");
  const Scene alone = read_text(next).scenes.at(0).scene;
  for (std::size_t i = 0; i < alone.particles.size(); ++i) {
    EXPECT_EQ(read.scenes[1].scene.particles[i].position, alone.particles[i].position);
    EXPECT_EQ(read.scenes[1].scene.particles[i].diameter, alone.particles[i].diameter);
  }
  for (int sample = 0; sample < 3; ++sample) EXPECT_EQ(read.scenes[sample].point.sample, sample);
}

TEST(Seeds, AreRefusedWhereNothingIsDrawnAtRandom) {
  const std::string text = example + "\n[sweep]\nseeds = 3\n";
  EXPECT_NE(refusal_of(text).find("seeds in a scene without a seed"), std::string::npos);
  EXPECT_NE(refusal_of(cloud("0.05") + "\n[sweep]\nseeds = 0\n").find("seeds = 0"), std::string::npos);
}

TEST(RandomSpins, AreBoundedAndNeedRotation) {
  const std::string text =
      with(cloud("0.05", "\nrandom_spin = 4.0\nseed = 9"), "[field]", "[bodies]\nrotation = true\n[field]");
  double largest = 0.0;
  const auto particles = read_text(text).scenes.at(0).scene.particles;
  for (const Particle& particle : particles)
    largest = std::max(largest, particle.angular_velocity.cwiseAbs().maxCoeff());
  EXPECT_LE(largest, 4.0);
  EXPECT_GT(largest, 3.5);
  EXPECT_NE(refusal_of(cloud("0.05", "\nrandom_spin = 4.0\nseed = 9"))
                .find("random_spin in a scene without rotation"),
            std::string::npos);
}

TEST(Tiers, AreQuickUnlessSaidOtherwise) {
  EXPECT_EQ(read_text(example).tier, Tier::quick);
  EXPECT_EQ(read_text(example_with("title", "tier = \"standard\"\ntitle")).tier, Tier::standard);
  EXPECT_EQ(read_text(example_with("title", "tier = \"bulk\"\ntitle")).tier, Tier::bulk);
  EXPECT_NE(refusal_of(example_with("title", "tier = \"slow\"\ntitle")).find("tier = \"slow\""),
            std::string::npos);
}

TEST(Bands, AreBetweenTwoEngines) {
  const std::string band =
      "\n[[expect]]\nquantity = \"bed_height\"\nagainst = \"engine:reference\"\nstatistic = \"band\"\nbelow "
      "= 1\n";
  EXPECT_EQ(read_text(example + band).expectations.at(0).statistic, Statistic::band);
  const std::string message = refusal_of(with(example + band, "engine:reference", "value:1"));
  EXPECT_NE(message.find("a band against \"value:1\""), std::string::npos) << message;
}

class SizeRefusal : public Refusal {};

TEST_P(SizeRefusal, NamesThePlaceWhatWasFoundAndWhatWasExpected) {
  expect_refused(GetParam(), cloud("{ uniform = [0.02, 0.06], seed = 1 }"));
}

const Mistake sizes[] = {
    {"LargestFirst", "uniform = [0.02, 0.06]", "uniform = [0.06, 0.02]", "uniform = [0.06, 0.02]",
     "least diameter first"},
    {"ThreeSizes", "uniform = [0.02, 0.06]", "uniform = [0.02, 0.04, 0.06]", "an array of 3",
     "two diameters"},
    {"SizeOfZero", "uniform = [0.02, 0.06]", "uniform = [0.0, 0.06]", "uniform = 0", "above 0"},
    {"SizesWithoutSeed", ", seed = 1", "", "no \"seed\"", "\"seed\"", "uniform ="},
    {"UnknownDistribution", "uniform = [0.02, 0.06]", "normal = [0.02, 0.06]", "unknown key \"normal\"",
     "\"uniform\""},
    {"EffectBelowTheLargest", "seed = 1 }", "seed = 1 }\neffect_diameter = 0.03", "effect_diameter = 0.03",
     "at least the body's diameter", "effect_diameter"},
    {"ManySizesForAFill", "diameter = { uniform = [0.02, 0.06], seed = 1 }", "diameters = [0.1, 0.2]",
     "unknown key \"diameters\"", "\"diameter\""},
    {"DistributionOfOneParticle", "diameter = 0.1\nfixed",
     "diameter = { uniform = [0.1, 0.2], seed = 1 }\nfixed", "a table", "a number",
     "diameter = { uniform = [0.1"},
    {"FewerSizesThanPositions", "diameter = 0.1\nfixed", "diameters = [0.1, 0.2]\nfixed", "diameters of 2",
     "each of the 1"},
    {"OneSizeAndMany", "diameter = 0.1\nfixed", "diameter = 0.1\ndiameters = [0.1]\nfixed",
     "both diameter and diameters", "one of the two", "diameters = [0.1]"},
};

INSTANTIATE_TEST_SUITE_P(, SizeRefusal, ::testing::ValuesIn(sizes), name_of_mistake);

}  // namespace
}  // namespace grainproof
