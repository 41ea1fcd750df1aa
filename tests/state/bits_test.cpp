// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <sstream>

#include "input/read_case.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "tests/device/crowds.hpp"
#include "tests/device/device_fixture.hpp"
#include "tests/device/driver_process.hpp"
#include "tests/device/varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

using Engines = std::vector<std::unique_ptr<RestartableEngine>>;

void add_device(Engines& engines, Path path) {
  for (const Precision precision : {Precision::single_precision, Precision::double_precision}) {
    EngineOptions options = options_for(precision);
    options.path = path;
    engines.push_back(std::make_unique<OpenClEngine>(options));
  }
}

/// Those who have bits of their own on a crowd of many.
Engines crowd_engines() {
  Engines engines;
  engines.push_back(std::make_unique<reference::ReferenceEngine>());
  for (const Path path : {Path::zoned, Path::dense}) add_device(engines, path);
  return engines;
}

Engines small_engines() {
  Engines engines;
  add_device(engines, Path::small);
  return engines;
}

Scene small_crowd(SumOrder order) {
  Scene scene = crowded_scene({.across = 7, .layers = 7});
  scene.run.order = order;
  return scene;
}

std::uint64_t digest_after(SteppingEngine& engine, const Scene& scene, std::int64_t steps) {
  const auto run = engine.start(scene, {});
  run->advance(steps);
  return run->digest();
}

void expect_the_same_in_twenty_runs(const Engines& engines, const Scene& scene) {
  for (const auto& engine : engines) {
    const std::uint64_t once = digest_after(*engine, scene, 60);
    for (int again = 1; again < 20; ++again)
      ASSERT_EQ(digest_after(*engine, scene, 60), once) << engine->name() << ", run " << again;
  }
}

// What a sentinel and a recorder do: frames, states, digests and checkpoints on the way.
void expect_the_same_when_looked_at(const Engines& engines, const Scene& scene) {
  for (const auto& engine : engines) {
    const auto run = engine->start(scene, {});
    for (int k = 0; k < 12; ++k) {
      run->frame();
      dynamic_cast<RestartableRun&>(*run).checkpoint();
      run->digest();
      run->advance(5);
    }
    EXPECT_EQ(run->digest(), digest_after(*engine, scene, 60)) << engine->name();
  }
}

class CrowdBits : public ::testing::TestWithParam<SumOrder> {
 protected:
  static Scene few() {
    Scene scene = varied_scene("turning_liggghts", 2);
    scene.run.order = GetParam();
    return scene;
  }
};

TEST_P(CrowdBits, DoNotChangeInTwentyRuns) {
  expect_the_same_in_twenty_runs(crowd_engines(), small_crowd(GetParam()));
  expect_the_same_in_twenty_runs(small_engines(), few());
}

TEST_P(CrowdBits, DoNotDependOnBeingLookedAt) {
  expect_the_same_when_looked_at(crowd_engines(), small_crowd(GetParam()));
  expect_the_same_when_looked_at(small_engines(), few());
}

/// Its particles, and nothing else, as a scene file has them, the k-th line being that of particle lines[k].
std::string particles_text(const Scene& scene, const std::vector<std::size_t>& lines) {
  std::ostringstream ids, positions, velocities;
  for (std::ostringstream* out : {&positions, &velocities}) out->precision(17);
  const auto write = [](std::ostringstream& out, const Vec3& v) {
    out << "[" << v.x() << ", " << v.y() << ", " << v.z() << "],\n";
  };
  for (const std::size_t i : lines) {
    ids << scene.particles[i].id << ", ";
    write(positions, scene.particles[i].position);
    write(velocities, scene.particles[i].velocity);
  }
  return "[[particles]]\nmaterial = \"glass\"\ndiameter = 0.1\nids = [" + ids.str() + "]\npositions = [\n" +
         positions.str() + "]\nvelocities = [\n" + velocities.str() + "]\n";
}

Scene read_with(SumOrder order, const std::string& particles) {
  const std::string rest =
      "schema = 1\n[run]\nend = 0.01\nstep = \"contact/60\"\norder = \"" +
      std::string(order == SumOrder::fast ? "fast" : "canonical") +
      "\"\n[domain]\nlower = [-4.0, 0.0, 10.0]\nupper = [-1.0, 3.0, 13.0]\n[bodies]\nrotation = true\n"
      "[material.glass]\ndensity = 2000.0\n[[contact]]\nbetween = [\"glass\", \"glass\"]\n"
      "normal = { law = \"linear\", stiffness = 1e5, restitution = 0.8 }\n"
      "friction = { law = \"history\", coefficient = 0.5, stiffness = 3e4 }\n";
  return read_case_text(rest + particles, "crowd.toml").scenes.front().scene;
}

TEST_P(CrowdBits, DoNotDependOnTheOrderOfParticlesInTheFile) {
  const Scene crowd = small_crowd(GetParam());
  std::vector<std::size_t> lines(crowd.particles.size());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  const Scene sorted = read_with(GetParam(), particles_text(crowd, lines));
  std::shuffle(lines.begin(), lines.end(), std::mt19937_64(7));
  const Scene shuffled = read_with(GetParam(), particles_text(crowd, lines));
  for (const auto& engine : crowd_engines()) {
    const std::uint64_t digest = digest_after(*engine, sorted, 60);
    EXPECT_EQ(digest_after(*engine, shuffled, 60), digest) << engine->name();
    EXPECT_NE(digest_after(*engine, sorted, 59), digest) << engine->name();
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, CrowdBits, ::testing::Values(SumOrder::fast, SumOrder::canonical),
                         [](const auto& param) {
                           return param.param == SumOrder::fast ? "fast" : "canonical";
                         });

TEST(ZonedBits, AreThoseOfOneThreadAndOfTwoWithADigestThatStates) {
  for (const char* precision : {"single", "mixed", "double"}) {
    const std::string arguments = std::string(precision) + " zoned leapfrog_verlet 2 100";
    const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments);
    const Finished two = run_driver("POCL_MAX_PTHREAD_COUNT=2", arguments);
    ASSERT_EQ(one.status, 0) << one.output;
    EXPECT_NE(one.output.find("digest"), std::string::npos);
    EXPECT_EQ(one.output, two.output) << precision;
  }
}

TEST(DenseBits, OfCanonicalOrderAreThoseOfOneThreadAndOfTwo) {
  for (const char* precision : {"single", "double"}) {
    const std::string arguments = std::string(precision) + " dense turning_liggghts 60 100 canonical";
    const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments);
    const Finished two = run_driver("POCL_MAX_PTHREAD_COUNT=2", arguments);
    ASSERT_EQ(one.status, 0) << one.output;
    EXPECT_NE(one.output.find("digest"), std::string::npos);
    EXPECT_EQ(one.output, two.output) << precision;
  }
}

}  // namespace
}  // namespace grainproof::opencl::testing
