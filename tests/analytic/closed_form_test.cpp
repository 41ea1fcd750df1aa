// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "analytic/closed_forms.hpp"
#include "model/errors.hpp"
#include "tests/analytic/exact_integration.hpp"
#include "tests/analytic/form_cases.hpp"

namespace grainproof::analytic {
namespace {

double difference(const Vec3& seen, const exact::State& state, int offset) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    largest =
        std::max(largest, std::abs(static_cast<double>(exact::Real(seen[axis]) - state[offset + axis])));
  return largest;
}

class EveryClosedForm : public testing::TestWithParam<FormCase> {
 protected:
  /// Body of a particle in exact::State: a single sphere against a wall is body 2.
  int body(std::size_t particle) const {
    return GetParam().scene.walls.empty() ? static_cast<int>(particle) : 1;
  }
};

TEST_P(EveryClosedForm, AgreesWithHighPrecisionIntegration) {
  const FormCase& c = GetParam();
  const auto engine = make_closed_form(c.form);
  const Support support = engine->supports(c.scene, {});
  ASSERT_TRUE(support) << support.because;
  const Observations seen = engine->observe(c.scene, {});
  const auto exact = exact::World(c.scene).integrate(c.scene.run.sample_times, c.time_scale / 64.0);
  ASSERT_EQ(seen.frames.size(), exact.size());
  for (std::size_t n = 0; n < exact.size(); ++n)
    for (std::size_t i = 0; i < c.scene.particles.size(); ++i) {
      EXPECT_LE(difference(seen.frames[n].position[i], exact[n], 3 * body(i)), c.position_roundoff)
          << "particle " << i << " at " << seen.frames[n].time;
      EXPECT_LE(difference(seen.frames[n].velocity[i], exact[n], 6 + 3 * body(i)), c.velocity_roundoff)
          << "particle " << i << " at " << seen.frames[n].time;
    }
}

/// Fourth-order central differences of the form's own positions and velocities, put into the law.
TEST_P(EveryClosedForm, ObeysItsEquationOfMotion) {
  const FormCase& c = GetParam();
  const exact::World world(c.scene);
  const double h = 1e-3 * c.time_scale;
  const auto engine = make_closed_form(c.form);
  int compared = 0;
  for (const double time : c.scene.run.sample_times) {
    if (time < 2.0 * h) continue;
    Request request;
    request.times = {time - 2 * h, time - h, time, time + h, time + 2 * h};
    const auto frames = engine->observe(c.scene, request).frames;
    std::array<exact::State, 5> states{};
    for (int k = 0; k < 5; ++k)
      for (std::size_t i = 0; i < c.scene.particles.size(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
          states[k][3 * body(i) + axis] = frames[k].position[i][axis];
          states[k][6 + 3 * body(i) + axis] = frames[k].velocity[i][axis];
        }
    const exact::Regime regime = world.regime(states[0]);
    bool smooth = true;
    for (const exact::State& state : states) smooth = smooth && world.regime(state) == regime;
    if (!smooth) continue;
    ++compared;
    const auto rate = [&](int at) {
      return static_cast<double>((states[0][at] - 8 * states[1][at] + 8 * states[3][at] - states[4][at]) /
                                 (12 * h));
    };
    const auto a = world.accelerations(states[2], regime);
    for (int at = 0; at < 6; ++at) {
      // Rounded values divided by h; beside that, (h/T)⁴ of the rate of change.
      EXPECT_LE(std::abs(rate(at) - static_cast<double>(states[2][6 + at])),
                1e-10 * c.speed_scale + c.position_roundoff / h)
          << time;
      EXPECT_LE(std::abs(rate(6 + at) - static_cast<double>(a[at / 3][at % 3])),
                1e-8 * c.speed_scale / c.time_scale)
          << time;
    }
  }
  EXPECT_GE(compared, 5);
}

INSTANTIATE_TEST_SUITE_P(, EveryClosedForm, testing::ValuesIn(form_cases()),
                         [](const auto& param) { return param.param.label; });

TEST(ClosedForms, AnalyticTakesTheFirstFormThatApplies) {
  for (const FormCase& c : form_cases()) {
    const auto engine = make_analytic_engine();
    ASSERT_TRUE(engine->supports(c.scene, {})) << c.label;
    EXPECT_EQ(engine->observe(c.scene, {}).provenance.variant, c.analytic_takes) << c.label;
  }
}

TEST(ClosedForms, AreEvaluatedAtTheTimesAsked) {
  const FormCase c = form_cases().front();
  Request request;
  request.times = {0.0, 0.1234567, 0.31};
  const Observations seen = make_closed_form(c.form)->observe(c.scene, request);
  ASSERT_EQ(seen.frames.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(seen.frames[n].time, request.times[n]);
  EXPECT_EQ(seen.provenance.engine, "closed_form");
}

TEST(ClosedForms, RefuseAnUnknownNameAndListTheKnown) {
  try {
    make_closed_form("fluid");
    FAIL();
  } catch (const InputRefused& refusal) {
    for (const std::string_view name : closed_form_names())
      EXPECT_NE(std::string(refusal.what()).find(name), std::string::npos);
  }
}

}  // namespace
}  // namespace grainproof::analytic
