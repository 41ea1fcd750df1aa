// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "crowds.hpp"
#include "device_fixture.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Named {
  const char* name;
  Crowd crowd;
  Integrator integrator = Integrator::onset_corrected;
};

constexpr std::array endless{Boundary::periodic, Boundary::periodic, Boundary::periodic};
constexpr std::array walled{Boundary::wall, Boundary::wall, Boundary::wall};

constexpr HistoryFriction liggghts{
    0.5, 8e4, 1.0, CoulombLimit::spring, TorqueArm::overlap, SpringTurn::project_and_rescale};

const Named crowds[] = {
    {"gas", {.friction = Frictionless{}, .rotation = false, .boundary = endless}},
    {"predicted_gas",
     {.friction = Frictionless{}, .rotation = false, .boundary = endless},
     Integrator::velocity_verlet_predicted},
    {"no_tension", {.friction = Frictionless{}, .rotation = false, .no_tension = true}},
    {"unequal", {.spread = 0.3, .friction = Frictionless{}, .rotation = false}},
    {"fixed", {.spread = 0.1, .friction = Frictionless{}, .rotation = false, .fixed = true}},
    {"viscous", {.friction = CollisionTimeFriction{0.4, 1e5}}},
    {"bed", {}},
    {"predicted_bed", {}, Integrator::velocity_verlet_predicted},
    {"liggghts", {.friction = liggghts}},
    {"bed_no_tension", {.spread = 0.2, .no_tension = true}},
    {"walled_bed", {.boundary = walled}},
    {"walled", {.friction = Frictionless{}, .rotation = false, .boundary = walled}},
};

Scene scene_of(const Named& named, SumOrder order) {
  Scene scene = crowded_scene(named.crowd);
  scene.run.integrator = named.integrator;
  scene.run.order = order;
  return scene;
}

EngineOptions on(Path path, Precision precision, double skin = 0.01) {
  EngineOptions options = options_for(precision);
  options.path = path;
  options.skin = skin;
  if (path == Path::zoned && getenv("HK")) options.kernels = getenv("HK");
  return options;
}

double norm(const std::vector<Vec3>& a, const std::vector<Vec3>& b = {}) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (b.empty() ? a[i] : Vec3(a[i] - b[i])).squaredNorm();
  return std::sqrt(sum);
}

double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  return b.empty() || a.size() != b.size() ? 0.0 : norm(a, b) / norm(b);
}

struct Ended {
  State state;
  Frame frame;
  std::uint64_t digest;
};

Ended ended(const EngineOptions& options, const Scene& scene, int at_once = crowd_steps) {
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  for (int done = 0; done < crowd_steps; done += at_once) run->advance(std::min(at_once, crowd_steps - done));
  return {run->state(), run->frame(), run->digest()};
}

std::vector<Vec3> springs_of(const State& state) {
  std::vector<Vec3> springs;
  for (const ContactMemory& memory : state.contacts) springs.push_back(memory.tangential_displacement);
  return springs;
}

class DenseOnset : public ::testing::TestWithParam<std::tuple<Named, Precision, SumOrder>> {
 protected:
  Precision precision() const { return std::get<1>(GetParam()); }
  Scene scene() const { return scene_of(std::get<0>(GetParam()), std::get<2>(GetParam())); }
  EngineOptions dense(double skin = 0.01) const { return on(Path::dense, precision(), skin); }
};

// As in test_dense.cpp; an event treated in another way is off by 1e-4 and more.
TEST_P(DenseOnset, AgreesWithTheZonedPathInDouble) {
  const double bar = precision() == Precision::single_precision ? 1e-5 : 1e-11;
  const Ended exact = ended(on(Path::zoned, Precision::double_precision), scene());
  const Ended seen = ended(dense(), scene());
  EXPECT_LT(difference(seen.state.velocity, exact.state.velocity), bar);
  EXPECT_LT(difference(seen.frame.velocity, exact.frame.velocity), bar);
  EXPECT_LT(difference(seen.state.angular_velocity, exact.state.angular_velocity), bar);
  EXPECT_LT(difference(springs_of(seen.state), springs_of(exact.state)), 10 * bar);
  double farthest = 0.0;
  for (std::size_t i = 0; i < seen.frame.position.size(); ++i) {
    Vec3 d = seen.frame.position[i] - exact.frame.position[i];
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = scene().domain.extent()[axis];
      if (scene().domain.periodic(axis)) d[axis] -= extent * std::round(d[axis] / extent);
    }
    farthest = std::max(farthest, d.norm());
  }
  EXPECT_LT(farthest, bar * diameter);
}

TEST_P(DenseOnset, BitsDoNotDependOnStepsAtOnceNorOnBeingLookedAt) {
  const Ended once = ended(dense(0.012), scene());
  EXPECT_EQ(ended(dense(0.012), scene(), 15).digest, once.digest);
  OpenClEngine engine(dense(0.012));
  const auto watched = engine.start(scene(), {});
  for (int done = 0; done < crowd_steps; done += 10) {
    watched->advance(10);
    watched->frame();
    watched->state();
  }
  EXPECT_EQ(watched->digest(), once.digest);
}

TEST_P(DenseOnset, BitsOfCanonicalOrderDoNotDependOnTheSkin) {
  if (std::get<2>(GetParam()) == SumOrder::fast) GTEST_SKIP();
  const std::uint64_t usual = ended(dense(), scene()).digest;
  // Skins below a tenth of a diameter are raised to it, for endings.
  EXPECT_EQ(ended(dense(0.013), scene()).digest, usual);
  EXPECT_EQ(ended(dense(0.025), scene()).digest, usual);
}

std::string name_of_crowd(const ::testing::TestParamInfo<std::tuple<Named, Precision, SumOrder>>& param) {
  return std::string(std::get<0>(param.param).name) + '_' + std::string(name_of(std::get<1>(param.param))) +
         (std::get<2>(param.param) == SumOrder::fast ? "_fast" : "_canonical");
}

INSTANTIATE_TEST_SUITE_P(Crowds, DenseOnset,
                         ::testing::Combine(::testing::ValuesIn(crowds),
                                            ::testing::Values(Precision::single_precision,
                                                              Precision::double_precision),
                                            ::testing::Values(SumOrder::fast, SumOrder::canonical)),
                         name_of_crowd);

}  // namespace
}  // namespace grainproof::opencl::testing
