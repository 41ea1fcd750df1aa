// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "comparisons/external/engine.hpp"
#include "comparisons/external/scene_json.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"
#include "tests/comparisons/one_dimension.hpp"

namespace grainproof::test {
namespace {

/// A shell command that ignores the scene and writes `content` as its frames.csv.
class Writer {
 public:
  explicit Writer(const std::string& content) { std::ofstream(folder_.path() / "content") << content; }
  std::string command() const {
    return "copy() { cp " + (folder_.path() / "content").string() + " $2/frames.csv; }; copy";
  }

 private:
  TemporaryFolder folder_;
};

Scene two_frames() {
  Scene scene = collision_with_fixed(10.0, 0.5);
  run_for(scene, 0.01, 0.001);
  return scene;
}

std::string complaint_about(const std::string& content) {
  const Writer writer(content);
  try {
    ExternalEngine(writer.command()).observe(two_frames(), {});
  } catch (const EngineFailed& failure) {
    return failure.what();
  }
  return "no complaint";
}

const std::string head = "time,id,x,y,z,vx,vy,vz\n";
const std::string first = "0,1,0,0,0,0,0,0\n0,2,0.1,0,0,-2,0,0\n";
const std::string last = "0.01,2,0.2,0,0,1.6,0,0\n0.01,1,0,0,0,0,0,0\n";

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(External, ExampleOfTheDocumentationIntegratesAHeadOnPair) {
  const Scene scene = collision_with_fixed(64.3, 0.7);
  ExternalEngine engine("python3 comparisons/external/example/head_on_pair.py");
  const Observations seen = engine.observe(scene, {});
  ASSERT_EQ(seen.frames.size(), 2u);
  const Ball expected = bounced(scene);
  EXPECT_NEAR(seen.frames.back().velocity[1].x() / expected.v, 1.0, 1e-12);
  EXPECT_NEAR(seen.frames.back().position[1].x(), expected.x, 1e-14);
  EXPECT_EQ(seen.frames.back().time, static_cast<double>(seen.frames.back().step) * scene.run.step);
}

TEST(External, RowsMayComeInAnyOrderWithFramesThatNobodyAskedFor) {
  const Writer writer(head + last + "0.005,1,7,0,0,0,0,0\n" + first);
  const Observations seen = ExternalEngine(writer.command()).observe(two_frames(), {});
  ASSERT_EQ(seen.frames.size(), 2u);
  EXPECT_EQ(seen.frames[0].velocity[1].x(), -2.0);
  EXPECT_EQ(seen.frames[1].position[1].x(), 0.2);
  EXPECT_EQ(seen.frames[1].step, 10);
}

TEST(External, AngularVelocitiesAreReadWhereBodiesTurn) {
  Scene scene = two_frames();
  scene.rotation = true;
  const std::string turning = "time,id,x,y,z,vx,vy,vz,wx,wy,wz\n";
  const Writer writer(turning + "0,1,0,0,0,0,0,0,0,0,0\n0,2,0.1,0,0,-2,0,0,0,0,0\n" +
                      "0.01,2,0.2,0,0,1.6,0,0,1,-2,0.1\n0.01,1,0,0,0,0,0,0,0,0,0\n");
  const Observations seen = ExternalEngine(writer.command()).observe(scene, {});
  EXPECT_EQ(seen.frames.back().angular_velocity[1], Vec3(1.0, -2.0, 0.1));
  const Writer without(head + first + last);
  EXPECT_THROW(ExternalEngine(without.command()).observe(scene, {}), EngineFailed);
}

TEST(External, FailureOfTheCommandIsReportedWithItsWords) {
  ExternalEngine engine("echo the licence has expired; exit 5; :");
  try {
    engine.observe(two_frames(), {});
    FAIL();
  } catch (const EngineFailed& failure) {
    EXPECT_TRUE(holds(failure.what(), "status 5")) << failure.what();
    EXPECT_TRUE(holds(failure.what(), "the licence has expired")) << failure.what();
  }
}

TEST(External, StatusThreeIsARunThatWentWrong) {
  const Observations seen = ExternalEngine("echo overlap too deep; exit 3; :").observe(two_frames(), {});
  EXPECT_EQ(seen.outcome.status, Outcome::Status::went_wrong);
  EXPECT_TRUE(holds(seen.outcome.reason, "overlap too deep"));
}

TEST(External, FilesThatAreNotAsDescribedAreRefusedWithWhatIsWrong) {
  EXPECT_TRUE(holds(complaint_about("x,y\n"), "expected the columns time,id"));
  EXPECT_TRUE(holds(complaint_about(head + "0,1,0,0,0,0,0\n"), "line 2"));
  EXPECT_TRUE(holds(complaint_about(head + first), "0.01 s (step 10) is missing"));
  EXPECT_TRUE(holds(complaint_about(head + first + "0.01,1,0,0,0,0,0,0\n"), "has 1 of 2 particles"));
  EXPECT_TRUE(holds(complaint_about(head + first + first + last), "already in the frame"));
  EXPECT_TRUE(holds(complaint_about(head + "0,9,0,0,0,0,0,0\n"), "no particle has this id"));
  try {
    ExternalEngine("true").observe(two_frames(), {});
    FAIL();
  } catch (const EngineFailed& failure) {
    EXPECT_TRUE(holds(failure.what(), "did not write it"));
  }
}

TEST(External, NumberThatIsNotFiniteEndsTheRun) {
  const Writer writer(head + first + "0.01,1,0,0,0,0,0,0\n0.01,2,nan,0,0,0,0,0\n");
  const Observations seen = ExternalEngine(writer.command()).observe(two_frames(), {});
  EXPECT_EQ(seen.outcome.status, Outcome::Status::went_wrong);
  EXPECT_EQ(seen.outcome.particles, std::vector<std::int64_t>{2});
  EXPECT_EQ(seen.frames.size(), 1u);
}

TEST(External, SceneFileHoldsEveryNumberInFull) {
  Scene scene = two_frames();
  scene.particles[1].position.x() = 0.1 + 1.0 / 3.0;
  scene.walls = {{"floor", 0, Plane{Vec3(0.0, 0.0, -0.5), Vec3::UnitZ()}}};
  const nlohmann::json read = nlohmann::json::parse(external::scene_json(scene, {}).dump());
  EXPECT_EQ(read["particles"][1]["position"][0].get<double>(), scene.particles[1].position.x());
  EXPECT_EQ(read["contacts"][0]["normal"]["restitution"].get<double>(), 0.8);
  EXPECT_EQ(read["run"]["frame_steps"], (nlohmann::json{0, 10}));
  EXPECT_EQ(read["walls"][0]["plane"]["normal"][2].get<double>(), 1.0);
  EXPECT_TRUE(read["flow"].is_null());
}

TEST(External, SceneFileHoldsHertzContactsWithTheirHistory) {
  Scene scene = two_frames();
  scene.rotation = true;
  scene.materials[0].elasticity = Elasticity{1.0 / 3.0, 0.3};
  scene.particles[1].angular_velocity.y() = 7.0;
  scene.contacts.set(0, 0,
                     {HertzNormal{Restitution{0.7}},
                      HistoryFriction{0.4, 0.0, 1.0, CoulombLimit::spring, TorqueArm::overlap}});
  const nlohmann::json read = nlohmann::json::parse(external::scene_json(scene, {}).dump());
  EXPECT_EQ(read["rotation"], true);
  EXPECT_EQ(read["materials"][0]["youngs_modulus"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(read["particles"][1]["angular_velocity"][1].get<double>(), 7.0);
  EXPECT_EQ(read["contacts"][0]["normal"], (nlohmann::json{{"law", "hertz"}, {"restitution", 0.7}}));
  EXPECT_EQ(read["contacts"][0]["friction"]["limit"], "spring");
  EXPECT_EQ(read["contacts"][0]["friction"]["arm"], "overlap");
  EXPECT_EQ(read["contacts"][0]["friction"]["turn"], "project");
  EXPECT_EQ(read["contacts"][0]["friction"]["memory"], "displacement");
  EXPECT_TRUE(read["contacts"][0]["rolling"].is_null());
}

}  // namespace
}  // namespace grainproof::test
