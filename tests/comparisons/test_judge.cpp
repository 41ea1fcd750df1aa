// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/judge.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {
namespace {

/// A collision with a wrong rebound: relative error `factor` × (step/contact)^order, alternating in sign
/// with the sample where `alternating`.
class Rebounder : public Engine {
 public:
  Rebounder(double factor, double order, double roundoff = 0x1p-53)
      : factor_(factor), order_(order), roundoff_(roundoff) {}

  std::string name() const override { return "rebounder"; }
  Support supports(const Scene&, const Request& request) const override {
    return request.ledger ? Support::no("keeps no ledger") : Support{};
  }
  Observations observe(const Scene& scene, const Request&) override {
    Observations seen;
    seen.provenance.precision = "double";
    seen.provenance.unit_roundoff = roundoff_;
    const double rebound =
        2.0 * restitution_value * (1.0 + factor_ * std::pow(scene.run.step / 0.01, order_));
    seen.frames.push_back(
        {0, 0.0, {Vec3::Zero(), scene.particles[1].position}, {Vec3::Zero(), Vec3(-2.0, 0.0, 0.0)}});
    seen.frames.push_back(
        {1, scene.run.end, {Vec3::Zero(), Vec3(0.2, 0.0, 0.0)}, {Vec3::Zero(), Vec3(rebound, 0.0, 0.0)}});
    return seen;
  }

 private:
  double factor_, order_, roundoff_;
};

Case collisions() {
  Case subject;
  subject.name = "collision";
  for (const int steps : {8, 16, 32, 64})
    for (int sample = 0; sample < 4; ++sample) {
      const Scene scene = collision_with_fixed(steps, (sample + 0.5) / 4.0);
      subject.scenes.push_back(
          {scene, {"contact/" + std::to_string(steps), static_cast<double>(steps), sample, {}}});
    }
  Expectation expectation;
  expectation.quantity = "restitution";
  expectation.against = "value:0.8";
  expectation.statistic = Statistic::rms;
  subject.expectations = {expectation};
  return subject;
}

TEST(Judge, MeasuresTheOrderThatAnEngineHas) {
  for (const double order : {1.0, 2.0, 3.0}) {
    Case subject = collisions();
    subject.expectations[0].order = OrderBound{"contact/8", "contact/64", order, 1e-6};
    Rebounder engine(0.1, order);
    const std::vector<Row> rows = judge(subject, engine, {});
    ASSERT_EQ(rows.size(), 1u);
    ASSERT_TRUE(rows[0].order.has_value()) << rows[0].reason;
    EXPECT_NEAR(*rows[0].order, order, 1e-9);
    EXPECT_EQ(rows[0].verdict, Verdict::pass) << rows[0].reason;
    EXPECT_EQ(rows[0].points.size(), 4u);
    EXPECT_EQ(rows[0].step, "");
  }
}

TEST(Judge, FailsAnOrderThatIsNotTheOneClaimed) {
  Case subject = collisions();
  subject.expectations[0].order = OrderBound{"contact/8", "contact/64", 2.0, 0.1};
  Rebounder engine(0.1, 1.0);
  const std::vector<Row> rows = judge(subject, engine, {});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].verdict, Verdict::fail);
}

TEST(Judge, HoldsEachStepAgainstItsOwnBound) {
  Case subject = collisions();
  const double step = subject.scenes[0].scene.run.step;
  const double error = 0.1 * step / 0.01;
  subject.expectations[0].below = {{"contact/8", 1.001 * error}, {"contact/16", 0.499 * error}};
  Rebounder engine(0.1, 1.0);
  const std::vector<Row> rows = judge(subject, engine, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].verdict, Verdict::pass) << rows[0].reason;
  EXPECT_NEAR(rows[0].error, error, 1e-12);
  EXPECT_EQ(rows[1].verdict, Verdict::fail);
  EXPECT_EQ(rows[1].samples, 4);
}

}  // namespace
}  // namespace grainproof::test
