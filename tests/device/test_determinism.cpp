// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdlib>
#include <memory>

#include "device_fixture.hpp"
#include "driver_process.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

std::uint64_t digest_of(const EngineOptions& options, const Scene& scene, const Request& request = {}) {
  OpenClEngine engine(options);
  const auto run = engine.start(scene, request);
  run->advance(varied_steps);
  return run->digest();
}

EngineOptions with_path(Precision precision, Path path, Stages stages = Stages::lean) {
  EngineOptions options = options_for(precision);
  options.path = path;
  options.stages = stages;
  return options;
}

using Varied = std::tuple<Precision, std::string>;

class SameBits : public ::testing::TestWithParam<Varied> {
 protected:
  Precision precision() const { return std::get<0>(GetParam()); }
  Scene scene() const { return varied_scene(std::get<1>(GetParam())); }
  /// These share their build of every stage, of which there is else one for each integrator and field.
  bool is_usual() const {
    const std::string& name = std::get<1>(GetParam());
    return name == "boxed" || name == "turning_liggghts" || name == "hertz_and_springs";
  }
};

TEST_P(SameBits, OnEveryPathAndInEveryBuild) {
  const std::uint64_t small = digest_of(with_path(precision(), Path::small), scene());
  Request ledger;
  ledger.ledger = true;
  EXPECT_EQ(digest_of(with_path(precision(), Path::zoned), scene()), small) << "zoned";
  EXPECT_EQ(digest_of(with_path(precision(), Path::small), scene(), ledger), small) << "with a ledger";
  // Every stage takes three times as long to compile, and whether one left idle changes a bit is no matter of
  // precision or path: everywhere in one scene of each kind of contact, in every scene in one.
  if (precision() == Precision::double_precision || is_usual()) {
    EXPECT_EQ(digest_of(with_path(precision(), Path::small, Stages::full), scene()), small) << "full";
  }
  if (is_usual()) {
    EXPECT_EQ(digest_of(with_path(precision(), Path::zoned, Stages::full), scene()), small) << "full, zoned";
  }
}

std::string varied_name(const ::testing::TestParamInfo<Varied>& param) {
  return std::string(name_of(std::get<0>(param.param))) + "_" + std::get<1>(param.param);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameBits,
                         ::testing::Combine(::testing::Values(Precision::single_precision,
                                                              Precision::double_precision),
                                            ::testing::ValuesIn(varied_scene_names())),
                         varied_name);
// Mixed is single's forces from double's positions: whatever starts from a position.
INSTANTIATE_TEST_SUITE_P(Mixed, SameBits,
                         ::testing::Combine(::testing::Values(Precision::mixed_precision),
                                            ::testing::Values("boxed", "turning_liggghts",
                                                              "hertz_and_springs", "sticky", "drum", "paddle",
                                                              "vortices", "central_gravity_in_rectangles")),
                         varied_name);

class ZonedBits : public ::testing::TestWithParam<Precision> {
 protected:
  static Scene scene() { return varied_scene("damped_friction", 40); }
  EngineOptions zoned() const { return with_path(GetParam(), Path::zoned); }
};

TEST_P(ZonedBits, DoNotChangeFromRunToRun) {
  EXPECT_EQ(digest_of(zoned(), scene()), digest_of(zoned(), scene()));
}

TEST_P(ZonedBits, DoNotDependOnTheWorkGroup) {
  const std::uint64_t usual = digest_of(zoned(), scene());
  for (const int group : {1, 16, 256}) {
    EngineOptions options = zoned();
    options.work_group = group;
    EXPECT_EQ(digest_of(options, scene()), usual) << "work-group " << group;
  }
}

TEST_P(ZonedBits, DoNotDependOnTheSkin) {
  const std::uint64_t usual = digest_of(zoned(), scene());
  for (const double skin : {0.0, 0.003, 0.04}) {
    EngineOptions options = zoned();
    options.skin = skin;
    EXPECT_EQ(digest_of(options, scene()), usual) << "skin " << skin;
  }
}

TEST_P(ZonedBits, DoNotDependOnHowStepsAreAskedFor) {
  OpenClEngine engine(zoned());
  const auto run = engine.start(scene(), {});
  for (int asked = 0; asked < varied_steps; asked += 25) {
    run->advance(25);
    run->synchronise();
  }
  EXPECT_EQ(run->digest(), digest_of(zoned(), scene()));
}

TEST_P(ZonedBits, DoNotDependOnTheNumberOfThreads) {
  const std::string arguments = std::string(name_of(GetParam())) + " zoned damped_friction 40 100";
  const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments);
  const Finished two = run_driver("POCL_MAX_PTHREAD_COUNT=2", arguments);
  const Finished all = run_driver("", arguments);
  ASSERT_EQ(one.status, 0) << one.output;
  EXPECT_NE(one.output.find("digest"), std::string::npos) << one.output;
  EXPECT_EQ(one.output, two.output);
  EXPECT_EQ(one.output, all.output);
}

/// Springs that live through many rebuilds, some of them across periodic faces.
class HistoryBits : public ::testing::TestWithParam<Precision> {};

TEST_P(HistoryBits, DoNotDependOnTheSkinNorOnThePath) {
  for (const char* name : {"turning_liggghts", "turning_periodic", "drum", "paddle"}) {
    Scene scene = varied_scene(name, 8);
    scene.run.order = SumOrder::canonical;
    const std::uint64_t usual = digest_of(with_path(GetParam(), Path::small), scene);
    for (const double skin : {0.0, 0.01, 0.05}) {
      EngineOptions options = with_path(GetParam(), Path::zoned);
      options.skin = skin;
      EXPECT_EQ(digest_of(options, scene), usual) << name << " with skin " << skin;
    }
  }
}

/// Bodies that touch from the start, go through a face together and are listed anew on the way.
TEST_P(HistoryBits, OutliveAFaceWithEverySkin) {
  Scene scene = varied_scene("paddle", 8);
  scene.run.order = SumOrder::canonical;
  scene.walls.clear();
  for (Particle& p : scene.particles) p.velocity += Vec3(20.0, 11.0, -17.0);
  const std::uint64_t usual = digest_of(with_path(GetParam(), Path::small), scene);
  for (const double skin : {0.0, 0.01, 0.05}) {
    EngineOptions options = with_path(GetParam(), Path::zoned);
    options.skin = skin;
    OpenClEngine engine(options);
    const auto run = engine.start(scene, {});
    run->advance(varied_steps);
    EXPECT_EQ(run->digest(), usual) << "skin " << skin;
    EXPECT_GT(run->counters().list_rebuilds, skin > 0.02 ? 2 : 5) << "skin " << skin;
    const State state = run->state();
    const bool wound = std::any_of(state.contacts.begin(), state.contacts.end(),
                                   [](const ContactMemory& m) { return m.rolling_torque.norm() > 0.0; });
    EXPECT_TRUE(wound);
  }
}

TEST_P(HistoryBits, DoNotDependOnThreadsWorkGroupOrHowStepsAreAskedFor) {
  const Scene scene = varied_scene("turning_liggghts", 40);
  EngineOptions options = with_path(GetParam(), Path::zoned);
  const std::uint64_t usual = digest_of(options, scene);
  options.work_group = 16;
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  for (int asked = 0; asked < varied_steps; asked += 20) {
    run->advance(20);
    run->synchronise();
  }
  EXPECT_GT(run->counters().list_rebuilds, 3);
  EXPECT_EQ(run->digest(), usual);
  const std::string arguments = std::string(name_of(GetParam())) + " zoned turning_liggghts 40 100";
  const Finished one = run_driver("POCL_MAX_PTHREAD_COUNT=1", arguments), all = run_driver("", arguments);
  ASSERT_EQ(one.status, 0) << one.output;
  EXPECT_EQ(one.output, all.output);
}

/// A scene that starts from where another run has come.
Scene going_on_from(Scene scene, const State& state) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    scene.particles[i].position = state.position[i];
    scene.particles[i].velocity = state.velocity[i];
    scene.particles[i].angular_velocity = state.angular_velocity[i];
  }
  scene.remembered = state.contacts;
  return scene;
}

TEST_P(HistoryBits, OfContactsThatRememberFromTheStartAreTheSameOnBothPaths) {
  for (const char* name : {"turning_liggghts", "paddle"}) {
    Scene scene = varied_scene(name);
    scene.walls.resize(name == std::string("paddle") ? 0 : scene.walls.size());
    OpenClEngine engine(with_path(GetParam(), Path::small));
    const auto run = engine.start(scene, {});
    run->advance(varied_steps / 2);
    const Scene later = going_on_from(scene, run->state());
    ASSERT_GT(later.remembered.size(), 3u);
    const std::uint64_t small = digest_of(with_path(GetParam(), Path::small), later);
    EXPECT_EQ(digest_of(with_path(GetParam(), Path::zoned), later), small) << name;
    Scene forgetful = later;
    forgetful.remembered.clear();
    EXPECT_NE(digest_of(with_path(GetParam(), Path::small), forgetful), small) << name;
  }
}

TEST_P(HistoryBits, AreOfTheSpringsToo) {
  const Scene scene = varied_scene("turning_liggghts");
  OpenClEngine engine(with_path(GetParam(), Path::zoned));
  const auto run = engine.start(scene, {});
  run->advance(varied_steps);
  const State state = run->state();
  EXPECT_GT(state.contacts.size(), 5u);
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const ContactMemory& memory = state.contacts[k];
    EXPECT_TRUE(memory.second < 0 || memory.first < memory.second);
    EXPECT_LE(state.contacts[k > 0 ? k - 1 : 0].first, memory.first);
  }
  ASSERT_EQ(state.angular_velocity.size(), scene.particles.size());
}

GRAINPROOF_IN_EVERY_PRECISION(HistoryBits);

GRAINPROOF_IN_EVERY_PRECISION(ZonedBits);

class Samples : public ::testing::TestWithParam<Precision> {};

TEST_P(Samples, TakenOnTheWayEqualThoseOfARunThatStopsForThem) {
  const Scene scene = varied_scene("leapfrog_verlet", 2);
  OpenClEngine engine(with_path(GetParam(), Path::small));
  Request every;
  every.every_step = true;
  const Observations on_the_way = engine.observe(scene, every);
  const Observations stopping = static_cast<SteppingEngine&>(engine).SteppingEngine::observe(scene, every);
  ASSERT_EQ(on_the_way.frames.size(), varied_steps + 1u);
  ASSERT_EQ(stopping.frames.size(), varied_steps + 1u);
  for (std::size_t k = 0; k < stopping.frames.size(); ++k) {
    EXPECT_EQ(on_the_way.frames[k].step, stopping.frames[k].step);
    EXPECT_EQ(on_the_way.frames[k].position, stopping.frames[k].position) << k;
    EXPECT_EQ(on_the_way.frames[k].velocity, stopping.frames[k].velocity) << k;
  }
}

TEST_P(Samples, EndBeforeTheStepThatWentWrong) {
  Scene scene = varied_scene("boxed", 2);
  scene.particles[4].velocity = {40, 0, 0};
  OpenClEngine engine(with_path(GetParam(), Path::small));
  Request every;
  every.every_step = true;
  const Observations seen = engine.observe(scene, every);
  ASSERT_EQ(seen.outcome.status, Outcome::Status::went_wrong);
  EXPECT_EQ(seen.frames.back().step, seen.outcome.step - 1);
}

GRAINPROOF_IN_EVERY_PRECISION(Samples);

TEST(Digest, TellsStatesApart) {
  const auto options = with_path(Precision::double_precision, Path::small);
  Scene other = varied_scene("boxed");
  other.particles[0].position.x() += 1e-15;
  EXPECT_NE(digest_of(options, varied_scene("boxed")), digest_of(options, other));
}

TEST(Digest, FollowsFrictionSoTheScenesDoTouch) {
  const auto options = with_path(Precision::double_precision, Path::small);
  EXPECT_NE(digest_of(options, varied_scene("boxed")), digest_of(options, varied_scene("dynamic_friction")));
}

}  // namespace
}  // namespace grainproof::opencl::testing
