// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "device_fixture.hpp"
#include "opencl/pair_list.hpp"
#include "scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Lists {
  std::vector<cl_int> starts, partners;

  std::vector<cl_int> of(std::size_t i) const {
    return {partners.begin() + starts[i], partners.begin() + starts[i + 1]};
  }
};

struct Shape {
  const char* name;
  Vec3 extent;
  std::array<Boundary, 3> boundary;
  double largest;  ///< diameter; the smallest is a quarter of it
};

constexpr double skin = 0.02;
constexpr Boundary open = Boundary::open, periodic = Boundary::periodic;

Scene cloud(const Shape& shape, int particles) {
  Scene scene = empty_scene(0.8);
  scene.domain = {Vec3(5, -3, 0.1), Vec3(5, -3, 0.1) + shape.extent, shape.boundary};
  std::mt19937_64 engine(7);
  const auto fraction = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  for (int i = 0; i < particles; ++i) {
    const Vec3 at = scene.domain.lower + shape.extent.cwiseProduct(Vec3(fraction(), fraction(), fraction()));
    scene.particles.push_back(sphere(i, at, Vec3::Zero(), shape.largest * (0.25 + 0.75 * fraction())));
    scene.particles.back().fixed = i % 7 == 0;
  }
  return scene;
}

Lists device_lists(const Scene& scene, Precision precision) {
  const EngineOptions options = options_for(precision);
  Workshop workshop(options.device, options.kernels);
  const BuildOptions build = build_options(scene, {}, precision, false);
  Program& program = workshop.program(build);
  const ZoneGrid grid = choose_zones(scene, skin);
  const SceneImage image = make_image(scene, precision, grid, 32);
  const auto decoder = make_decoder(precision, scene.domain);
  const World world = make_world(workshop, image, *decoder, build);
  PairList list(workshop, program, image, *decoder, grid, 32);
  list.build(world);
  list.build(world);  // again, since every buffer is used again
  Lists found{std::vector<cl_int>(image.padded + 1),
              std::vector<cl_int>(static_cast<std::size_t>(list.entries()))};
  workshop.read(list.starts(), std::as_writable_bytes(std::span(found.starts)));
  if (list.entries() > 0) workshop.read(list.partners(), std::as_writable_bytes(std::span(found.partners)));
  return found;
}

double gap(const Scene& scene, std::size_t i, std::size_t j) {
  const Particle &a = scene.particles[i], &b = scene.particles[j];
  Vec3 d = b.position - a.position;
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis)) {
      const double extent = scene.domain.extent()[axis];
      d[axis] -= extent * std::round(d[axis] / extent);
    }
  return d.norm() - (a.diameter + b.diameter) / 2;
}

std::vector<cl_int> brute_force(const Scene& scene, std::size_t i) {
  std::vector<cl_int> partners;
  if (scene.particles[i].fixed) return partners;
  for (std::size_t j = 0; j < scene.particles.size(); ++j)
    if (j != i && gap(scene, i, j) < skin) partners.push_back(static_cast<cl_int>(j));
  return partners;
}

using Case = std::tuple<Precision, Shape>;

class PairListOf : public ::testing::TestWithParam<Case> {};

TEST_P(PairListOf, EveryParticleEqualsBruteForceInOrderOfId) {
  const auto& [precision, shape] = GetParam();
  const Scene scene = cloud(shape, 700);
  const Lists lists = device_lists(scene, precision);
  std::size_t total = 0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    ASSERT_EQ(lists.of(i), brute_force(scene, i)) << "particle " << i;
    total += lists.of(i).size();
  }
  EXPECT_GT(total, 700u);
}

const Shape shapes[] = {
    {"open", {1.5, 1.0, 1.2}, {open, open, open}, 0.12},
    {"periodic", {1.5, 1.0, 1.2}, {periodic, periodic, periodic}, 0.12},
    {"slit_of_one_zone", {2.0, 2.0, 0.26}, {periodic, open, periodic}, 0.12},
    {"slit_of_two_zones", {2.0, 2.0, 0.3}, {open, periodic, periodic}, 0.12},
    {"one_zone", {0.2, 0.2, 0.2}, {open, open, open}, 0.12},
};

INSTANTIATE_TEST_SUITE_P(
    Shapes, PairListOf, ::testing::Combine(::testing::ValuesIn(every_precision), ::testing::ValuesIn(shapes)),
    [](const ::testing::TestParamInfo<Case>& param) {
      return std::string(name_of(std::get<0>(param.param))) + "_" + std::get<1>(param.param).name;
    });

}  // namespace
}  // namespace grainproof::opencl::testing
