// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <random>

#include "model/errors.hpp"
#include "model/ledger_numbers.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "tests/device/crowds.hpp"
#include "tests/device/device_fixture.hpp"
#include "tests/device/varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

using Make = std::function<std::unique_ptr<RestartableEngine>()>;

struct Subject {
  std::string name;
  Make make;
};

Subject on_path(Precision precision, Path path, const std::string& name, Width width = Width::automatic) {
  return {name, [=] {
            EngineOptions options = options_for(precision);
            options.path = path;
            options.width = width;
            return std::make_unique<OpenClEngine>(options);
          }};
}

const Subject reference_subject{"reference", [] { return std::make_unique<reference::ReferenceEngine>(); }};

std::vector<Subject> device_subjects() {
  return {on_path(Precision::single_precision, Path::small, "single_small"),
          on_path(Precision::single_precision, Path::zoned, "single_zoned"),
          on_path(Precision::mixed_precision, Path::small, "mixed_small"),
          on_path(Precision::mixed_precision, Path::zoned, "mixed_zoned"),
          on_path(Precision::double_precision, Path::small, "double_small"),
          on_path(Precision::double_precision, Path::zoned, "double_zoned")};
}

std::vector<std::int64_t> random_steps(int count, std::int64_t below) {
  std::mt19937_64 dice(20261122);
  std::vector<std::int64_t> steps;
  for (int i = 0; i < count; ++i)
    steps.push_back(static_cast<std::int64_t>(dice() % static_cast<std::uint64_t>(below)));
  return steps;
}

/// Every run of a restartable engine can be gone on from.
std::unique_ptr<RestartableRun> started(RestartableEngine& engine, const Scene& scene,
                                        const Request& request) {
  auto run = engine.start(scene, request);
  auto* restartable = dynamic_cast<RestartableRun*>(run.get());
  EXPECT_NE(restartable, nullptr);
  run.release();
  return std::unique_ptr<RestartableRun>(restartable);
}

/// Stops at each of `stops`, on the way, throws the run away and goes on from its checkpoint.
std::unique_ptr<RestartableRun> with_stops(RestartableEngine& engine, const Scene& scene,
                                           std::vector<std::int64_t> stops, std::int64_t steps,
                                           const Request& request = {}) {
  std::sort(stops.begin(), stops.end());
  auto run = started(engine, scene, request);
  std::int64_t done = 0;
  for (const std::int64_t stop : stops) {
    run->advance(stop - done);
    done = stop;
    Resumed resumed = engine.resume(scene, request, run->checkpoint());
    EXPECT_EQ(resumed.not_exact_because, "") << engine.name() << " at step " << stop;
    run = std::move(resumed.run);
  }
  run->advance(steps - done);
  return run;
}

/// Runs that stop at `stops` and go on must end as one that does not.
void expect_same_bits(const Subject& subject, const Scene& scene, const std::vector<std::int64_t>& stops,
                      std::int64_t steps, const Request& request = {}) {
  const auto engine = subject.make();
  if (!engine->supports(scene, request)) return;
  const auto straight = engine->start(scene, request);
  straight->advance(steps);
  const auto stopped = with_stops(*engine, scene, stops, steps, request);
  EXPECT_EQ(stopped->digest(), straight->digest()) << subject.name;
  EXPECT_EQ(stopped->counters().steps, steps);
  EXPECT_EQ(stopped->counters().list_rebuilds, straight->counters().list_rebuilds) << subject.name;
  EXPECT_EQ(numbers_of(stopped->ledger()), numbers_of(straight->ledger())) << subject.name;
}

const Request with_ledger{.times = {}, .ledger = true};

// A stop at the start is among them: there the leap-frog has not been pushed off yet.
TEST(Restart, ChangesNoBitOfTheReferenceOrItsLedger) {
  std::vector<std::int64_t> stops = random_steps(20, varied_steps);
  stops.push_back(0);
  for (const std::string& name : varied_scene_names()) {
    SCOPED_TRACE(name);
    expect_same_bits(reference_subject, varied_scene(name), stops, varied_steps, with_ledger);
  }
}

// So many that the reference numbers them along the cells, with every 32nd list.
TEST(Restart, ChangesNoBitOfTheReferenceInItsFastOrder) {
  Scene scene = crowded_scene({.across = 16, .layers = 16});
  scene.run.skin = 0.0;
  for (const SumOrder order : {SumOrder::fast, SumOrder::canonical}) {
    scene.run.order = order;
    expect_same_bits(reference_subject, scene, {0, 20, 34}, 40);
  }
}

class DeviceRestart : public ::testing::TestWithParam<std::string> {};

TEST_P(DeviceRestart, ChangesNoBitOnAnyPathOrOfTheLedger) {
  std::vector<std::int64_t> stops = random_steps(20, 120);
  stops.push_back(0);
  for (const Subject& subject : device_subjects())
    expect_same_bits(subject, varied_scene(GetParam(), 2), stops, 120, with_ledger);
}

// A kernel that is compiled takes seconds: a scene for each thing that runs keep in their own way.
INSTANTIATE_TEST_SUITE_P(Scenes, DeviceRestart,
                         ::testing::Values("leapfrog_verlet", "paddle", "hertz_and_springs",
                                           "rotating_gravity"),
                         [](const auto& param) { return param.param; });

TEST(SchemeRestart, ChangesNoBitWhereForcesAreEvaluatedSeveralTimesAStep) {
  for (const Integrator integrator : {Integrator::velocity_verlet_implicit, Integrator::pefrl}) {
    Scene scene = varied_scene("hertz_and_springs", 2);
    scene.run.integrator = integrator;
    expect_same_bits(reference_subject, scene, {0, 1, 37, 80}, 120);
    for (const Subject& subject : device_subjects()) expect_same_bits(subject, scene, {0, 1, 37, 80}, 120);
  }
}

TEST(DenseRestart, ChangesNoBitInEitherOrder) {
  Scene scene = crowded_scene({.across = 7, .layers = 7});
  for (const Precision precision : opencl::every_precision) {
    const Subject dense = on_path(precision, Path::dense, std::string(name_of(precision)) + "_dense");
    for (const SumOrder order : {SumOrder::fast, SumOrder::canonical}) {
      scene.run.order = order;
      std::vector<std::int64_t> stops = random_steps(20, crowd_steps);
      stops.push_back(0);
      expect_same_bits(dense, scene, stops, crowd_steps);
    }
  }
}

TEST(DenseRestart, ChangesNoBitByOneParticleAWorkItem) {
  const Scene scene = crowded_scene({.across = 8, .layers = 8});
  const Subject one = on_path(Precision::single_precision, Path::dense, "dense by one", Width::one);
  expect_same_bits(one, scene, {0, 31, 32, 90}, crowd_steps);
  const auto many = on_path(Precision::single_precision, Path::automatic, "dense").make();
  const auto before = started(*one.make(), scene, {});
  before->advance(20);
  const std::string because = many->resume(scene, {}, before->checkpoint()).not_exact_because;
  EXPECT_NE(because.find("dense by one"), std::string::npos) << because;
}

/// Largest distance of a particle, over the largest diameter, between a run that never stops and one that
/// another engine takes over at half its time.
double apart_after_handing_over(RestartableEngine& first, RestartableEngine& second, const Scene& scene) {
  const auto straight = second.start(scene, with_ledger);
  const auto before = started(first, scene, with_ledger);
  before->advance(60);
  const Resumed taken = second.resume(scene, with_ledger, before->checkpoint());
  EXPECT_NE(taken.not_exact_because, "");
  EXPECT_EQ(taken.run->frame().step, 60);
  EXPECT_NEAR(taken.run->ledger().gravity_work, before->ledger().gravity_work, 1e-6);
  taken.run->advance(60);
  straight->advance(120);
  const Frame one = taken.run->frame(), other = straight->frame();
  EXPECT_EQ(one.step, 120);
  EXPECT_EQ(one.time, other.time);
  EXPECT_NEAR(taken.run->ledger().balance(), straight->ledger().balance(), 1e-2 * straight->ledger().kinetic);
  double apart = 0.0;
  for (std::size_t i = 0; i < one.position.size(); ++i)
    apart = std::max(apart, (one.position[i] - other.position[i]).norm() / 0.1);
  return apart;
}

// Velocities stand at the boundary where they are handed over, so nothing is lost but roundings, and half a
// step of the springs and dashpots that are then told of the new velocity: with 60 steps a contact less than
// a thousandth of a diameter.
TEST(HandedOver, ARunGoesOnOnAnotherEngineAtTheSameTime) {
  reference::ReferenceEngine reference;
  OpenClEngine single(options_for(Precision::single_precision));
  for (const char* name : {"leapfrog_verlet", "drum", "rotating_gravity"}) {
    SCOPED_TRACE(name);
    const Scene scene = varied_scene(name, 2);
    EXPECT_LT(apart_after_handing_over(reference, single, scene), 1e-3);
    EXPECT_LT(apart_after_handing_over(single, reference, scene), 1e-3);
  }
}

TEST(HandedOver, ACheckpointOfOtherParticlesIsRefused) {
  reference::ReferenceEngine reference;
  const auto run = started(reference, varied_scene("boxed", 2), {});
  EXPECT_THROW(reference.resume(varied_scene("boxed", 3), {}, run->checkpoint()), InputRefused);
}

TEST(HandedOver, ACheckpointThatLacksAPartOfItsOwnIsSaidNotToBeExact) {
  reference::ReferenceEngine reference;
  const Scene scene = varied_scene("boxed", 2);
  Checkpoint from = started(reference, scene, {})->checkpoint();
  from.own.erase(from.own.begin());
  EXPECT_NE(reference.resume(scene, {}, from).not_exact_because.find("lacks its part"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::opencl::testing
