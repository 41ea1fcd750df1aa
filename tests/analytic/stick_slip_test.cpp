// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "analytic/closed_forms.hpp"
#include "analytic/contact_scales.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

constexpr double g = 9.81, k_t = 2e4, mu = 0.4, k = 1e5;

struct Drag {
  const char* label;
  double speed;  ///< m/s, at the start
  double pull;   ///< of gravity along the wall, over that across it
  double damping_ratio;
  CoulombLimit limit;
};

Scene scene_of(const Drag& drag) {
  Scene scene = glass_scene();
  const HistoryFriction friction{mu, k_t, drag.damping_ratio, drag.limit};
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{k, Restitution{0.5}}, friction});
  add_floor(scene);
  scene.gravity = ConstantGravity{{drag.pull * g, 0.0, -g}};
  const double rest = sphere_mass(2000.0, 0.1) * g / k;
  add_sphere(scene, {0.0, 0.0, 0.05 - rest}, {drag.speed, 0.0, 0.0});
  scene.run.end = 0.3;
  scene.run.sample_times.clear();
  for (int n = 0; n <= 30; ++n) scene.run.sample_times.push_back(0.01 * n);
  return scene;
}

/// The law of docs/laws/history.md step by step, as an engine has it.
struct Stepped {
  double x = 0.0, v = 0.0, spring = 0.0;
  int slipped = 0;  ///< steps at the limit

  void step(const Drag& drag, double h) {
    const double mass = sphere_mass(2000.0, 0.1), limit = mu * mass * g;
    const double eta = drag.damping_ratio * damping({k, Restitution{0.5}}, mass);
    spring += v * h;
    double force = k_t * spring + eta * v;
    if (drag.limit == CoulombLimit::spring_and_dashpot && std::abs(force) > limit) {
      force = std::copysign(limit, force);
      spring = (force - eta * v) / k_t;
      ++slipped;
    }
    if (drag.limit == CoulombLimit::spring && k_t * std::abs(spring) > limit) {
      force = std::copysign(limit, spring);
      spring = force / k_t;
      ++slipped;
    }
    v += h * (drag.pull * g - force / mass);
    x += h * v;
  }
};

class StickSlip : public testing::TestWithParam<Drag> {};

/// Both are of first order in the step, so that halving it must halve the difference.
TEST_P(StickSlip, IsWhatTheLawStepByStepConvergesTo) {
  const Drag& drag = GetParam();
  const Scene scene = scene_of(drag);
  const auto form = make_closed_form("stick_slip");
  ASSERT_TRUE(form->supports(scene, {})) << form->supports(scene, {}).because;
  const Observations seen = form->observe(scene, {});
  double worst[2]{};
  int slipped = 0;
  for (const int halved : {0, 1}) {
    const int steps = 20000 << halved;
    Stepped stepped{0.0, drag.speed, 0.0};
    for (int n = 1; n <= 30; ++n) {
      for (int i = 0; i < steps; ++i) stepped.step(drag, 0.01 / steps);
      const Frame& frame = seen.frames[static_cast<std::size_t>(n)];
      worst[halved] = std::max(worst[halved], std::abs(frame.velocity[0].x() - stepped.v));
      worst[halved] = std::max(worst[halved], 100.0 * std::abs(frame.position[0].x() - stepped.x));
    }
    slipped = stepped.slipped;
  }
  EXPECT_LE(worst[1], 1e-4);  // of speeds up to 1 m/s, at steps of 5e-7 s
  EXPECT_LE(worst[1], 0.6 * worst[0]);
  EXPECT_EQ(seen.scalars.at("slips") > 0.0, slipped > 2);
}

INSTANTIATE_TEST_SUITE_P(
    , StickSlip,
    testing::Values(Drag{"FromRestItSwings", 0.0, 0.15, 0.0, CoulombLimit::spring_and_dashpot},
                    Drag{"FromRestItSlipsOnceOverTheLimit", 0.0, 0.3, 0.0, CoulombLimit::spring},
                    Drag{"FromRestItSlipsForEver", 0.0, 0.5, 0.2, CoulombLimit::spring_and_dashpot},
                    Drag{"FromSlidingItSticks", 1.0, 0.0, 0.3, CoulombLimit::spring_and_dashpot},
                    Drag{"FromSlidingItSticksWithoutDashpot", 1.0, 0.05, 0.3, CoulombLimit::spring},
                    Drag{"SlowlyItNeverSlips", 0.02, 0.0, 0.1, CoulombLimit::spring_and_dashpot}),
    [](const auto& param) { return std::string(param.param.label); });

TEST(StickSlipForm, IsRefusedWhereItIsNotExact) {
  const auto why = [](const Scene& scene) {
    return make_closed_form("stick_slip")->supports(scene, {}).because;
  };
  const Drag drag{"", 1.0, 0.0, 0.3, CoulombLimit::spring};
  Scene turning = scene_of(drag);
  turning.rotation = true;
  EXPECT_NE(why(turning), "");
  Scene lifted = scene_of(drag);
  lifted.particles[0].position.z() += 1e-6;
  EXPECT_NE(why(lifted).find("resting overlap"), std::string::npos);
  Scene turned = scene_of(drag);
  turned.gravity = ConstantGravity{{0.0, 1.0, -g}};
  EXPECT_NE(why(turned).find("slip turns"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::analytic
