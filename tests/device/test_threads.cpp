// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <thread>

#include "device_fixture.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

constexpr int rounds = 6;

bool same(const Observations& a, const Observations& b) {
  return a.frames.back().position == b.frames.back().position &&
         a.frames.back().velocity == b.frames.back().velocity;
}

// Two scenes of one program and several launches a step, so that threads that did not take turns would set
// each other's kernel arguments.
TEST(Threads, ObserveOnOneEngineAsIfAlone) {
  EngineOptions options = options_for(Precision::double_precision);
  options.path = Path::zoned;
  OpenClEngine engine(options);
  const Scene scenes[] = {varied_scene("history", 3), varied_scene("history", 4)};
  const Observations alone[] = {engine.observe(scenes[0], {}), engine.observe(scenes[1], {})};
  int alike[] = {0, 0};
  const auto repeat = [&](int k) {
    for (int round = 0; round < rounds; ++round)
      alike[k] += same(engine.observe(scenes[k], {}), alone[k]) ? 1 : 0;
  };
  std::thread one(repeat, 0), two(repeat, 1);
  one.join();
  two.join();
  EXPECT_EQ(alike[0], rounds);
  EXPECT_EQ(alike[1], rounds);
}

}  // namespace
}  // namespace grainproof::opencl::testing
