// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "analytic/contact_scales.hpp"
#include "analytic/step_for_error.hpp"
#include "benchmarks/common/contact_errors.hpp"
#include "benchmarks/common/pair_gas.hpp"

namespace grainproof {
namespace {

using analytic::ErrorLaw;
using analytic::MeasuredErrors;

/// Three digits are kept, and a compiler may round otherwise.
constexpr double same = 0.02;

void expect_as_measured(const MeasuredErrors& row) {
  for (std::size_t i : {std::size_t{1}, std::size_t{3}}) {
    const double now =
        bench::contact_error(row.law, row.integrator, row.restitution, analytic::measured_at.at(i));
    EXPECT_NEAR(now, row.error.at(i), same * row.error.at(i))
        << name_of(row.law) << ", " << name_of(row.integrator) << ", restitution " << row.restitution << ", "
        << analytic::measured_at.at(i) << " steps";
  }
}

bool has_closed_form(ErrorLaw law) {
  return law != ErrorLaw::linear_history && law != ErrorLaw::hertz_history;
}

TEST(StepConstants, AreWhatTheReferenceMakesNow) {
  ASSERT_GT(analytic::measured_errors().size(), 50u);
  for (const MeasuredErrors& row : analytic::measured_errors())
    if (has_closed_form(row.law)) expect_as_measured(row);
}

TEST(StepConstants, OfHistoryFrictionAreWhatTheReferenceMakesNow) {
  for (const MeasuredErrors& row : analytic::measured_errors())
    if (!has_closed_form(row.law) && row.restitution == 0.8) expect_as_measured(row);
}

Scene colliding(double restitution) {
  bench::PairGas gas{.name = "one", .pairs = 1, .restitution = restitution, .spread = 0.0, .counted_in = 1.0};
  return bench::pair_scene(gas, 1.0);
}

/// Restitutions on a row of the table and between two, where the worse of both counts. A root mean square
/// over 400 contacts is itself uncertain by some percent.
TEST(StepByError, MakesTheErrorThatWasAskedForAndNoMore) {
  for (double restitution : {0.9, 0.8, 0.7, 0.5})
    for (double error : {1e-2, 1e-3, 4e-4}) {
      const Scene scene = colliding(restitution);
      const analytic::StepForError choice = analytic::step_for_error(scene, error);
      ASSERT_EQ(choice.lacks, "");
      const double steps = analytic::shortest_contact(scene)->duration / choice.step;
      const double made =
          bench::contact_error(ErrorLaw::linear, Integrator::velocity_verlet, restitution, steps);
      EXPECT_LT(made, 1.15 * error) << restitution << ", " << choice.because;
      EXPECT_GT(made, 0.5 * error) << restitution << ", " << choice.because;
    }
}

TEST(StepByError, StaysBelowASafeShareOfTheStabilityLimit) {
  Scene scene = colliding(0.8);
  scene.run.integrator = Integrator::euler_trapezoid;
  const analytic::StepForError choice = analytic::step_for_error(scene, 0.5);
  ASSERT_EQ(choice.lacks, "");
  EXPECT_DOUBLE_EQ(choice.step, analytic::safe_share * analytic::stability_limit(scene).step);
  EXPECT_NE(choice.because.find("40 % of the stability limit"), std::string::npos) << choice.because;
}

TEST(StepByError, IsNeverCoarserThanWhatWasMeasured) {
  const Scene scene = colliding(1.0);
  const analytic::StepForError choice = analytic::step_for_error(scene, 0.4);
  EXPECT_DOUBLE_EQ(choice.step, analytic::shortest_contact(scene)->duration / analytic::measured_at.front());
}

TEST(StepByError, KnowsNothingOfLawsThatWereNotMeasured) {
  Scene scene = colliding(0.8);
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.cohesion = LinearCohesion{1.0};
  scene.contacts.set(0, 0, laws);
  EXPECT_NE(analytic::step_for_error(scene, 1e-3).lacks.find("cohesion"), std::string::npos);
}

/// With Hertz' law and history friction a spring is cut back where the normal force passes through zero
/// before the spheres part, if a step falls there: at low restitution the error stops falling.
TEST(StepByError, PromisesNoErrorThatWasNotFoundToBeReached) {
  const MeasuredErrors stalled{ErrorLaw::hertz_history,
                               Integrator::velocity_verlet,
                               0.4,
                               {0.02, 0.014, 0.0118, 0.0113, 0.0111, 0.0111}};
  EXPECT_FALSE(analytic::steps_for_error(stalled, 1e-3));
  ASSERT_TRUE(analytic::steps_for_error(stalled, 1.5e-2));
  EXPECT_NEAR(analytic::steps_for_error(stalled, 1.4e-2)->steps, 16.0, 1e-9);
}

TEST(StepByError, TakesDragIntoAccount) {
  Scene scene = colliding(1.0);
  scene.flow = UniformFlow{100.0 * bench::pair_viscosity(), Vec3::Zero()};
  const analytic::StepForError with = analytic::step_for_error(scene, 1e-3);
  ASSERT_EQ(with.lacks, "");
  EXPECT_NE(with.because.find("drag"), std::string::npos) << with.because;
}

}  // namespace
}  // namespace grainproof
