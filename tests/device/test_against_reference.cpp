// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with every law, walls that move and bodies that lie somehow: a hundred steps of both engines.
#include <algorithm>
#include <limits>
#include <tuple>

#include "device_fixture.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Ran {
  Frame frame;
  State state;
  Ledger ledger;
};

Ran ran(SteppingEngine& engine, const Scene& scene) {
  Request request;
  request.ledger = true;
  const auto run = engine.start(scene, request);
  run->advance(varied_steps);
  run->synchronise();
  return {run->frame(), run->state(), run->ledger()};
}

double largest(const std::vector<Vec3>& vectors) {
  double most = 0.0;
  for (const Vec3& v : vectors) most = std::max(most, v.norm());
  return most;
}

double difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!((a[i] - b[i]).norm() <= most)) most = (a[i] - b[i]).norm();
  return most;
}

using Way = std::tuple<Path, std::string>;

class AgainstReference : public ::testing::TestWithParam<Way> {
 protected:
  void SetUp() override {
    const Scene scene = varied_scene(std::get<1>(GetParam()));
    EngineOptions options = options_for(Precision::double_precision);
    options.path = std::get<0>(GetParam());
    OpenClEngine engine(options);
    reference::ReferenceEngine reference;
    seen_ = ran(engine, scene);
    expected_ = ran(reference, scene);
  }

  /// A hundred steps of a few contacts each make some hundred roundings, and no contact has parted neighbours
  /// yet.
  static constexpr double tolerance = 1e-11;
  Ran seen_, expected_;
};

TEST_P(AgainstReference, BodiesGoAndTurnAlike) {
  EXPECT_LE(difference(seen_.frame.velocity, expected_.frame.velocity),
            tolerance * largest(expected_.frame.velocity));
  EXPECT_LE(difference(seen_.frame.angular_velocity, expected_.frame.angular_velocity),
            tolerance * largest(expected_.frame.angular_velocity));
  ASSERT_EQ(seen_.frame.orientation.size(), expected_.frame.orientation.size());
  for (std::size_t i = 0; i < seen_.frame.orientation.size(); ++i)
    EXPECT_LE((seen_.frame.orientation[i].coeffs() - expected_.frame.orientation[i].coeffs()).norm(),
              tolerance)
        << i;
}

TEST_P(AgainstReference, ContactsRememberAlike) {
  const auto by_name = [](std::vector<ContactMemory> all) {
    std::sort(all.begin(), all.end(), [](const ContactMemory& a, const ContactMemory& b) {
      return std::tie(a.first, a.second) < std::tie(b.first, b.second);
    });
    return all;
  };
  const auto seen = by_name(seen_.state.contacts), expected = by_name(expected_.state.contacts);
  ASSERT_EQ(seen.size(), expected.size());
  for (std::size_t k = 0; k < seen.size(); ++k) {
    EXPECT_EQ(seen[k].first, expected[k].first);
    EXPECT_EQ(seen[k].second, expected[k].second);
    EXPECT_LE((seen[k].tangential_displacement - expected[k].tangential_displacement).norm(), 1e-14) << k;
    EXPECT_LE(std::abs(seen[k].overlap - expected[k].overlap), 1e-14) << k;
    const double torque = expected[k].rolling_torque.norm();
    EXPECT_LE((seen[k].rolling_torque - expected[k].rolling_torque).norm(), 1e-9 * torque + 1e-12) << k;
  }
}

TEST_P(AgainstReference, LedgersAreAlike) {
  const Ledger &a = seen_.ledger, &b = expected_.ledger;
  const double energy = 1e-11 * b.kinetic;
  EXPECT_LE(std::abs(a.kinetic - b.kinetic), energy);
  EXPECT_LE(std::abs(a.elastic - b.elastic), energy);
  EXPECT_LE(std::abs(a.wall_work - b.wall_work), energy);
  EXPECT_LE(std::abs(a.dissipated_normal - b.dissipated_normal), energy);
  EXPECT_LE(std::abs(a.dissipated_tangential - b.dissipated_tangential), energy);
  EXPECT_LE(std::abs(a.dissipated_rolling - b.dissipated_rolling), energy);
  EXPECT_LE(difference(a.wall_impulses, b.wall_impulses), 1e-11 * largest(b.wall_impulses));
  EXPECT_LE(difference(a.wall_angular_impulses, b.wall_angular_impulses),
            1e-11 * largest(b.wall_angular_impulses));
}

INSTANTIATE_TEST_SUITE_P(Scenes, AgainstReference,
                         ::testing::Combine(::testing::Values(Path::small, Path::zoned),
                                            ::testing::Values("drum", "paddle", "rolling_steadily",
                                                              "hertz_and_springs", "turning_liggghts")),
                         [](const ::testing::TestParamInfo<Way>& param) {
                           return std::string(std::get<0>(param.param) == Path::small ? "small_" : "zoned_") +
                                  std::get<1>(param.param);
                         });

}  // namespace
}  // namespace grainproof::opencl::testing
