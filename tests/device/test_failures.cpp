// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <filesystem>
#include <fstream>

#include "device_fixture.hpp"
#include "model/errors.hpp"
#include "opencl/device_error.hpp"
#include "opencl/workshop.hpp"
#include "scenes.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

using Way = std::tuple<Precision, Path>;

class Failures : public ::testing::TestWithParam<Way> {
 protected:
  Outcome outcome(Scene scene) {
    EngineOptions options = options_for(std::get<0>(GetParam()));
    options.path = std::get<1>(GetParam());
    scene.run.sample_times = {0.0, scene.run.end};
    OpenClEngine engine(options);
    return engine.observe(scene, {}).outcome;
  }
};

void expect_named(const Outcome& outcome, const std::string& words, std::vector<std::int64_t> ids) {
  EXPECT_EQ(outcome.status, Outcome::Status::went_wrong);
  EXPECT_NE(outcome.reason.find(words), std::string::npos) << outcome.reason;
  EXPECT_EQ(outcome.particles, ids);
}

/// One of four leaves through the upper y face at step 50.
Scene escaping_scene() {
  Scene scene = empty_scene(0.8);
  scene.run.step = 1e-3;
  scene.run.end = 0.2;
  scene.particles = {sphere(3, {0, 0, 0}, {0, 0, 0}), sphere(5, {0.5, 0.9, 0}, {0, 2.02, 0}),
                     sphere(8, {-0.5, 0, 0}, {0, 0, 0}), sphere(9, {0, 0.85, 0.5}, {0, 2.02, 0})};
  return scene;
}

TEST_P(Failures, AnEscapeIsNamedWithStepTimeParticleAndFace) {
  const Outcome seen = outcome(escaping_scene());
  expect_named(seen, "particle 5 left the domain through the upper y face", {5});
  EXPECT_EQ(seen.step, 50);
  EXPECT_DOUBLE_EQ(seen.time, 0.05);
  EXPECT_NE(seen.reason.find("step"), std::string::npos);
}

TEST_P(Failures, TheSmallestIdIsNamedWhenSeveralGoWrongAtOnce) {
  Scene scene = escaping_scene();
  scene.particles[3].position.y() = 0.9;
  expect_named(outcome(scene), "particle 5 ", {5});
}

TEST_P(Failures, AParticleThatMayLeapOverAnotherIsNamed) {
  Scene scene = escaping_scene();
  scene.particles[2].velocity.x() = 1.01 * 0.5 * scene.particles[2].diameter / scene.run.step;
  const Outcome seen = outcome(scene);
  expect_named(seen, "particle 8 moved by more than its radius in one step", {8});
  EXPECT_EQ(seen.step, 1);
}

TEST_P(Failures, TooDeepAnOverlapIsNamedWithBothParticles) {
  Scene scene = empty_scene(0.8);
  scene.run.end = 0.1;
  scene.particles = {sphere(4, {0, 0, 0}, {20, 0, 0}), sphere(7, {0.2, 0, 0}, {-20, 0, 0})};
  expect_named(outcome(scene), "particle 4 overlaps particle 7 by more than 0.5", {4, 7});
}

TEST_P(Failures, TooDeepAnOverlapWithAWallNamesTheWall) {
  Scene scene = settling_scene(10);
  scene.particles[0].velocity.z() = -20;
  expect_named(outcome(scene), "particle 0 overlaps wall floor", {0});
}

TEST_P(Failures, AnOverlapThatIsThereFromTheStartIsStepZero) {
  Scene scene = empty_scene(0.8);
  scene.run.end = 0.1;
  scene.particles = {sphere(0, {0, 0, 0}, {0, 0, 0}), sphere(1, {0.05, 0, 0}, {0, 0, 0})};
  EXPECT_EQ(outcome(scene).step, 0);
}

TEST_P(Failures, AVelocityThatIsNoNumberIsNamed) {
  Scene scene = escaping_scene();
  scene.particles[2].velocity.x() = std::nan("");
  const Outcome seen = outcome(scene);
  expect_named(seen, "particle 8 has a position or velocity that is not a number", {8});
  EXPECT_EQ(seen.step, 1);
}

INSTANTIATE_TEST_SUITE_P(Ways, Failures,
                         ::testing::Combine(::testing::ValuesIn(every_precision),
                                            ::testing::Values(Path::small, Path::zoned)),
                         [](const ::testing::TestParamInfo<Way>& param) {
                           return std::string(name_of(std::get<0>(param.param))) +
                                  (std::get<1>(param.param) == Path::small ? "_small" : "_zoned");
                         });

TEST(Engine, TellsMixedPrecisionByItsName) {
  OpenClEngine engine(options_for(Precision::mixed_precision));
  EXPECT_EQ(engine.name(), "opencl:mixed");
  EXPECT_EQ(engine.provenance().precision, "mixed");
  EXPECT_EQ(engine.provenance().unit_roundoff, single_roundoff);
}

TEST(Engine, SaysWhichDevicesThereAreWhenAskedForAnother) {
  EngineOptions options = options_for(Precision::single_precision);
  options.device = "no such device";
  try {
    OpenClEngine engine(options);
    FAIL() << "no device was missed";
  } catch (const EngineFailed& failure) {
    EXPECT_NE(std::string(failure.what()).find("0: "), std::string::npos) << failure.what();
  }
}

TEST(Engine, RefusesAPeriodicBoxInWhichAPairCouldMeetTwice) {
  Scene scene = head_on_scene(0.8, 64);
  scene.domain.boundary[1] = Boundary::periodic;
  scene.domain.lower.y() = -0.09;
  scene.domain.upper.y() = 0.09;
  OpenClEngine engine(options_for(Precision::double_precision));
  EXPECT_FALSE(engine.supports(scene, {}));
}

TEST(Workshop, NamesTheFileAndLineOfAKernelThatDoesNotCompile) {
  const auto folder = std::filesystem::temp_directory_path() / "grainproof-broken-kernels";
  std::filesystem::remove_all(folder);
  std::filesystem::copy(GRAINPROOF_KERNELS, folder);
  std::ofstream(folder / "contact.cl", std::ios::app) << "\nthis is no OpenCL\n";
  Workshop workshop("", folder);
  try {
    workshop.program(BuildOptions{});
    FAIL() << "a broken kernel was built";
  } catch (const DeviceError& failure) {
    EXPECT_NE(failure.build_log.find("contact.cl"), std::string::npos) << failure.what();
    EXPECT_EQ(failure.device, workshop.device_name());
    EXPECT_EQ(failure.call, "clBuildProgram");
  }
}

TEST(Workshop, RefusesALaunchWithTheWrongNumberOfArguments) {
  const EngineOptions options = options_for(Precision::single_precision);
  Workshop workshop(options.device, options.kernels);
  Program& program = workshop.program(BuildOptions{Precision::single_precision});
  EXPECT_THROW(workshop.launch(program, "scan_reduce", {1, 1}, cl_int{1}), DeviceError);
}

}  // namespace
}  // namespace grainproof::opencl::testing
