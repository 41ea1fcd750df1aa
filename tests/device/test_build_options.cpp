// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "opencl/build_options.hpp"
#include "scenes.hpp"
#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

BuildOptions options_of(const Scene& scene, const Request& request = {}, bool small = true) {
  return build_options(scene, request, Precision::double_precision, small);
}

std::vector<std::string> files_of(const BuildOptions& options) {
  return kernel_files(options, false);
}

bool has(const std::vector<std::string>& files, const std::string& name) {
  return std::find(files.begin(), files.end(), name) != files.end();
}

TEST(BuildOptions, AFreePairNeedsNothingButTheNormalLaw) {
  const BuildOptions o = options_of(head_on_scene(0.8, 64));
  EXPECT_EQ(o, (BuildOptions{.precision = Precision::double_precision, .small = true}));
  const auto files = files_of(o);
  for (const char* absent : {"friction_viscous.cl", "cohesion_linear.cl", "planes.cl", "rectangles.cl",
                             "gravity_constant.cl", "drag_in_force.cl", "ledger_kept.cl", "zones.cl"})
    EXPECT_FALSE(has(files, absent)) << absent;
}

TEST(BuildOptions, FrictionThatNoPairInPlayHasIsLeftOut) {
  Scene scene = head_on_scene(0.8, 64);
  scene.materials.push_back({"unused", 1.0});
  ContactTable table(2);
  table.set(0, 0, scene.contacts.at(0, 0));
  table.set(0, 1, {LinearNormal{1e5, Restitution{0.8}}, DynamicFriction{0.5}, LinearCohesion{1.0}});
  scene.contacts = table;
  EXPECT_FALSE(options_of(scene).friction);
  EXPECT_FALSE(options_of(scene).cohesion);
  scene.walls = {{"floor", 1, Plane{Vec3::Zero(), Vec3::UnitZ()}}};
  EXPECT_TRUE(options_of(scene).friction);
  EXPECT_TRUE(options_of(scene).cohesion);
}

TEST(BuildOptions, RotationHistoryAndHertzAreLeftOutUnlessASceneHasThem) {
  const BuildOptions plain = options_of(varied_scene("damped_friction"));
  EXPECT_FALSE(plain.rotation || plain.history || plain.hertz);
  for (const char* absent : {"rotation.cl", "history.cl", "rise_hertz.cl", "boundary_spin.cl"})
    EXPECT_FALSE(has(files_of(plain), absent)) << absent;
  const BuildOptions hertz = options_of(varied_scene("hertz"), {}, false);
  EXPECT_TRUE(hertz.rotation && hertz.history && hertz.hertz);
  EXPECT_FALSE(hertz.friction);
  EXPECT_TRUE(has(files_of(hertz), "carry.cl"));
  EXPECT_FALSE(options_of(varied_scene("history")).rotation);
}

TEST(BuildOptions, RollingMovingWallsAndOrientationsAreLeftOutUnlessASceneHasThem) {
  const auto plain = files_of(options_of(varied_scene("turning_liggghts"), {}, false));
  for (const char* absent : {"rolling.cl", "rolling_spring.cl", "rolling_constant.cl", "walls_moving.cl",
                             "cylinders.cl", "orientation_kept.cl", "booking.cl"})
    EXPECT_FALSE(has(plain, absent)) << absent;
  const auto drum = files_of(options_of(varied_scene("drum")));
  for (const char* there : {"rolling.cl", "rolling_spring.cl", "rolling_constant_none.cl", "walls_moving.cl",
                            "cylinders.cl", "orientation_exponential.cl"})
    EXPECT_TRUE(has(drum, there)) << there;
}

TEST(BuildOptions, WallsOutOfReachAreLeftOut) {
  Scene scene = head_on_scene(0.8, 64);
  scene.walls = {{"below", 0, Plane{{0, 0, -1.06}, Vec3::UnitZ()}},
                 {"beside", 0, Rectangle{{1.06, -1, -1}, {1.06, 1, 1}}}};
  EXPECT_FALSE(options_of(scene).planes);
  EXPECT_FALSE(options_of(scene).rectangles);
  scene.walls = {{"floor", 0, Plane{{0, 0, -1.04}, Vec3::UnitZ()}},
                 {"side", 0, Rectangle{{1.04, -1, -1}, {1.04, 1, 1}}}};
  EXPECT_TRUE(options_of(scene).planes);
  EXPECT_TRUE(options_of(scene).rectangles);
}

TEST(BuildOptions, FieldsBringTheirOwnFiles) {
  const auto vortices = files_of(options_of(varied_scene("vortices")));
  EXPECT_TRUE(has(vortices, "flow_taylor_green.cl"));
  EXPECT_TRUE(has(vortices, "drag_in_force.cl"));
  EXPECT_TRUE(has(vortices, "gravity_none.cl"));
  const auto implicit = files_of(options_of(varied_scene("implicit_drag")));
  EXPECT_TRUE(has(implicit, "drag_by_integrator.cl"));
  EXPECT_TRUE(has(implicit, "flow_uniform.cl"));
  EXPECT_TRUE(has(files_of(options_of(varied_scene("rotating_gravity"))), "gravity_rotating.cl"));
}

TEST(BuildOptions, EveryIntegratorIsAFile) {
  for (const auto& [name, integrator] : integrator_names) {
    Scene scene = head_on_scene(0.8, 64);
    scene.run.integrator = integrator;
    EXPECT_TRUE(has(files_of(options_of(scene)), std::string(name) + ".cl"));
  }
}

TEST(BuildOptions, CorrectionsAreBookedWhereALedgerIsKept) {
  Scene scene = head_on_scene(0.8, 64);
  scene.run.integrator = Integrator::onset_corrected;
  Request ledger;
  ledger.ledger = true;
  const auto with = files_of(options_of(scene, ledger)), without = files_of(options_of(scene));
  EXPECT_TRUE(has(with, "onset_booked.cl") && has(with, "ledger_kept.cl"));
  EXPECT_FALSE(has(with, "events_none.cl"));
  EXPECT_TRUE(has(without, "onset_unbooked.cl") && has(without, "ledger_none.cl"));
  EXPECT_TRUE(has(without, "events_none.cl"));
}

TEST(BuildOptions, PeriodicityAndMaterialsAreDefinitions) {
  Scene scene = head_on_scene(0.8, 64);
  scene.domain.boundary[1] = Boundary::periodic;
  EXPECT_EQ(definitions(options_of(scene)),
            " -D PERIODIC_X=0 -D PERIODIC_Y=1 -D PERIODIC_Z=0 -D MANY_MATERIALS=0");
}

TEST(BuildOptions, FullHasEveryStageAndTheScenesOwnFields) {
  const BuildOptions full = with_every_stage(options_of(varied_scene("vortices")));
  EXPECT_TRUE(full.friction && full.cohesion && full.planes && full.rectangles && full.ledger &&
              full.many_materials);
  EXPECT_EQ(full.flow, FlowKind::taylor_green);
  EXPECT_EQ(full.gravity, GravityKind::constant);
}

TEST(BuildOptions, ThePrecisionChoosesHowPositionsAreHeld) {
  BuildOptions o;
  EXPECT_TRUE(has(files_of(o), "position_double.cl"));
  o.precision = Precision::mixed_precision;
  EXPECT_TRUE(has(files_of(o), "position_double.cl"));
  EXPECT_TRUE(has(files_of(o), "lengths_mixed.cl"));
  EXPECT_TRUE(has(files_of(o), "velocity_compensated.cl"));
  o.precision = Precision::single_precision;
  EXPECT_TRUE(has(files_of(o), "position_fixed.cl"));
  EXPECT_FALSE(has(files_of(o), "real_double.cl"));
}

}  // namespace
}  // namespace grainproof::opencl::testing
