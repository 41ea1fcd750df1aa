// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string_view>

#include "crowds.hpp"
#include "device_fixture.hpp"
#include "model/errors.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Named {
  const char* name;
  Crowd crowd;
  Integrator integrator = Integrator::velocity_verlet;
};

constexpr HistoryFriction liggghts{
    0.5, 8e4, 1.0, CoulombLimit::spring, TorqueArm::overlap, SpringTurn::project_and_rescale};
constexpr std::array walled{Boundary::wall, Boundary::wall, Boundary::wall};
constexpr std::array endless{Boundary::periodic, Boundary::periodic, Boundary::periodic};

const Named crowds[] = {
    {"bed", {}},
    {"bands", {.across = 13, .layers = 6}},  // more rows of zones than stand abreast
    {"liggghts", {.friction = liggghts}},
    {"no_tension", {.no_tension = true}},
    {"collision_time_friction", {.friction = CollisionTimeFriction{0.4, 1e5}}},
    {"step_friction_without_rotation", {.friction = StepFriction{0.4, 1e5}, .rotation = false}},
    {"frictionless_gas", {.friction = Frictionless{}, .rotation = false, .boundary = endless}},
    {"unequal", {.spread = 0.3}},
    {"fixed", {.spread = 0.1, .fixed = true}},
    {"walled", {.boundary = walled}},
    {"leapfrog", {}, Integrator::leapfrog_verlet},
};

Scene scene_of(const Named& named) {
  Scene scene = crowded_scene(named.crowd);
  scene.run.integrator = named.integrator;
  return scene;
}

EngineOptions on(Path path, Precision precision = Precision::single_precision) {
  EngineOptions options = options_for(precision);
  options.path = path;
  return options;
}

double norm(const std::vector<Vec3>& a, const std::vector<Vec3>& b = {}) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (b.empty() ? a[i] : Vec3(a[i] - b[i])).squaredNorm();
  return std::sqrt(sum);
}

struct Errors {
  double velocity, spin, springs;
};

std::vector<Vec3> springs_of(const State& state) {
  std::vector<Vec3> springs;
  for (const ContactMemory& memory : state.contacts) springs.push_back(memory.tangential_displacement);
  return springs;
}

State final_state(const EngineOptions& options, const Scene& scene, std::int64_t* rebuilds = nullptr) {
  OpenClEngine engine(options);
  const auto run = engine.start(scene, {});
  run->advance(crowd_steps);
  run->synchronise();
  if (rebuilds != nullptr) *rebuilds = run->counters().list_rebuilds;
  return run->state();
}

/// Relative, against the zoned path in double.
Errors errors_of(const EngineOptions& options, const Scene& scene) {
  const State exact = final_state(on(Path::zoned, Precision::double_precision), scene);
  const State seen = final_state(options, scene);
  Errors e{norm(seen.velocity, exact.velocity) / norm(exact.velocity), 0.0, 0.0};
  if (scene.rotation)
    e.spin = norm(seen.angular_velocity, exact.angular_velocity) / norm(exact.angular_velocity);
  const auto springs = springs_of(seen), wanted = springs_of(exact);
  EXPECT_EQ(springs.size(), wanted.size());
  if (!wanted.empty() && springs.size() == wanted.size()) e.springs = norm(springs, wanted) / norm(wanted);
  return e;
}

// A unit of position is 1e-9 of a diameter in single precision, some 1e-6 of the overlaps here; 150 steps
// with two or three collisions each make of it what they make of any error: 5e-7 was measured. A law that is
// wrong in one term is off by 1e-2 and more.
constexpr double single_bar = 1e-5;
// Both paths round by some 1e-16 then, with overlaps of 1e-3 of the distances they come from.
constexpr double double_bar = 1e-11;

using Way = std::tuple<Named, Precision, Width, SumOrder>;

class Dense : public ::testing::TestWithParam<Way> {
 protected:
  Scene scene() const {
    Scene scene = scene_of(std::get<0>(GetParam()));
    scene.run.order = std::get<3>(GetParam());
    return scene;
  }
  EngineOptions dense() const {
    EngineOptions options = on(Path::dense, std::get<1>(GetParam()));
    options.width = std::get<2>(GetParam());
    return options;
  }
  double bar() const {
    return std::get<1>(GetParam()) == Precision::single_precision ? single_bar : double_bar;
  }
};

std::string name_of_crowd(const ::testing::TestParamInfo<Way>& param) {
  return std::string(std::get<0>(param.param).name) + '_' + std::string(name_of(std::get<1>(param.param))) +
         (std::get<2>(param.param) == Width::one ? "_by_one" : "") +
         (std::get<3>(param.param) == SumOrder::fast ? "" : "_canonical");
}

TEST_P(Dense, AgreesWithTheZonedPathInDouble) {
  const Errors e = errors_of(dense(), scene());
  EXPECT_LT(e.velocity, bar());
  EXPECT_LT(e.spin, bar());
  EXPECT_LT(e.springs, 10 * bar());
}

TEST_P(Dense, FirstFrameIsTheSceneItself) {
  const Scene scene = this->scene();
  OpenClEngine engine(dense());
  const Frame frame = engine.start(scene, {})->frame();
  const double rounding = bar() == single_bar ? 1e-7 : 1e-15;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    EXPECT_LT((frame.position[i] - scene.particles[i].position).norm(), 1e-2 * rounding * diameter + 1e-15);
    EXPECT_LT((frame.velocity[i] - scene.particles[i].velocity).norm(), rounding);
  }
}

bool is_of_most(std::string_view crowd) {
  return crowd == "liggghts" || crowd == "unequal" || crowd == "walled";
}

// Programs take seconds to compile. Every law goes once by each type of numbers; in the other order or width
// a law is the same text, and what differs is how sums are made: there those with springs, unequal spheres
// and walls.
std::vector<Way> ways() {
  using enum Precision;
  std::vector<Way> all;
  for (const Named& crowd : crowds)
    for (const Precision precision : {single_precision, double_precision})
      for (const Width width : {Width::many, Width::one})
        for (const SumOrder order : {SumOrder::fast, SumOrder::canonical}) {
          const bool usual = precision == single_precision
                                 ? (width == Width::many) == (order == SumOrder::fast)
                                 : width == Width::many && order == SumOrder::canonical;
          if (usual || is_of_most(crowd.name)) all.emplace_back(crowd, precision, width, order);
        }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Crowds, Dense, ::testing::ValuesIn(ways()), name_of_crowd);

TEST(DenseRun, IsTakenByItselfWhereItCan) {
  const Scene scene = crowded_scene({});
  EXPECT_EQ(OpenClEngine(on(Path::automatic)).start(scene, {})->digest(),
            OpenClEngine(on(Path::dense)).start(scene, {})->digest());
}

TEST(DenseRun, IsRefusedWithAReasonWhereItCannot) {
  Scene scene = crowded_scene({});
  scene.flow = UniformFlow{1e-3, Vec3::Zero()};
  OpenClEngine engine(on(Path::dense));
  EXPECT_THROW(engine.start(scene, {}), EngineFailed);
}

// Its force turns with the slip at any speed, however small, so that rounding decides wherever bodies stick.
TEST(DenseRun, IsAsCloseToDoubleAsTheZonedPathUnderDynamicFriction) {
  const Scene scene = crowded_scene({.friction = DynamicFriction{0.4}});
  EXPECT_LT(errors_of(on(Path::dense), scene).velocity, 2 * errors_of(on(Path::zoned), scene).velocity);
}

TEST(DenseRun, RoundsNoMotionAwayHoweverSlow) {
  Scene scene = crowded_scene({.friction = Frictionless{}, .rotation = false});
  scene.gravity = ConstantGravity{Vec3::Zero()};
  for (Particle& p : scene.particles) {
    p.diameter = p.effect_diameter = 0.09;
    p.velocity *= 1e-8;  // some hundredths of a unit of position a step
  }
  OpenClEngine engine(on(Path::dense));
  const auto run = engine.start(scene, {});
  run->advance(crowd_steps);
  const Frame frame = run->frame();
  double error = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    const Vec3 wanted = p.position + p.velocity * scene.run.end;
    error = std::max(error, (frame.position[i] - wanted).norm());
  }
  EXPECT_LT(error, 1e-3 * 1e-8 * scene.run.end);
}

TEST(DenseRun, GrowsItsRowsForABigOneAmongMany) {
  Scene scene = crowded_scene({.across = 12, .friction = Frictionless{}, .rotation = false});
  for (Particle& p : scene.particles) p.diameter = p.effect_diameter = 0.045;
  Particle& big = scene.particles[555];
  big.diameter = big.effect_diameter = 0.15;
  EngineOptions options = on(Path::dense);
  options.skin = 0.14;  // some 90 within reach of the big one
  const State exact = final_state(on(Path::zoned, Precision::double_precision), scene);
  EXPECT_LT(norm(final_state(options, scene).velocity, exact.velocity) / norm(exact.velocity), single_bar);
}

/// A copy of the kernels with one mistake in it.
std::filesystem::path kernels_with(const std::string& file, const std::string& right,
                                   const std::string& wrong) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("grainproof-dense-" + std::to_string(getpid()) + "-" + file);
  std::filesystem::remove_all(folder);
  std::filesystem::copy(GRAINPROOF_KERNELS, folder);
  std::ifstream original(folder / file);
  std::string text{std::istreambuf_iterator<char>(original), {}};
  const auto at = text.find(right);
  EXPECT_NE(at, std::string::npos) << right;
  if (at != std::string::npos) text.replace(at, right.size(), wrong);
  original.close();
  std::ofstream(folder / file) << text;
  return folder;
}

struct Mistake {
  const char* name;
  const char* file;
  const char* right;
  const char* wrong;
};

const Mistake mistakes[] = {
    {"springs_are_not_carried", "dense_springs.cl", "if ((at & ~LAST_PARTNER) == partner)",
     "if ((at & ~LAST_PARTNER) == partner && partner > WALL_PARTNER)"},
    {"springs_of_walls_are_not_carried", "dense_springs.cl", "if ((at & ~LAST_PARTNER) == partner)",
     "if ((at & ~LAST_PARTNER) == partner && partner < WALL_PARTNER)"},
    {"springs_do_not_turn", "dense_hold.cl", "carried_springs(*spring, m, law.history)", "*spring"},
    {"torque_has_the_wrong_sign", "dense_hold.cl", "scaled(outer(m.normal, g.rubbing), -m.arm)",
     "scaled(outer(m.normal, g.rubbing), m.arm)"},
    {"sweep_forgets_the_partner", "dense_pairs.cl", "return scaled(plus_scaled(a, b, (reals)(1)), arm);",
     "return scaled(a, arm);"},
    {"a_row_beyond_the_face_is_missed", "dense_near.cl", "(z < 0 ? z + zones : z - zones)", "-1"},
    {"the_last_band_is_taken_for_a_full_one", "dense_order.cl", "within % width", "within % box->periodic.w"},
    {"a_quotient_is_an_estimate", "dense_roots.cl", "fma(y, fma(-x, y, (reals)(1)), y)", "y"},
    {"a_root_is_an_estimate", "dense_roots.cl", "fma(y, fma(x * y * -0.5f, y, (reals)(0.5f)), y)", "y"},
};

class DenseMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(DenseMistakes, AreNoticed) {
  if (std::string_view(GetParam().file) == "dense_roots.cl" && !__builtin_cpu_supports("avx512f"))
    GTEST_SKIP() << "only AVX-512 estimates roots";
  EngineOptions options = on(Path::dense);
  options.kernels = kernels_with(GetParam().file, GetParam().right, GetParam().wrong);
  options.skin = 0.002;
  const Scene scene = crowded_scene({.across = 13, .layers = 6});
  const State exact = final_state(on(Path::zoned, Precision::double_precision), scene);
  const State seen = final_state(options, scene);
  const bool springs_differ =
      seen.contacts.size() != exact.contacts.size() ||
      norm(springs_of(seen), springs_of(exact)) > 10 * single_bar * norm(springs_of(exact));
  EXPECT_TRUE(norm(seen.velocity, exact.velocity) > single_bar * norm(exact.velocity) ||
              norm(seen.angular_velocity, exact.angular_velocity) >
                  single_bar * norm(exact.angular_velocity) ||
              springs_differ);
}

INSTANTIATE_TEST_SUITE_P(Planted, DenseMistakes, ::testing::ValuesIn(mistakes),
                         [](const ::testing::TestParamInfo<Mistake>& param) { return param.param.name; });

}  // namespace
}  // namespace grainproof::opencl::testing
