// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "model/errors.hpp"
#include "model/ledger_numbers.hpp"
#include "tests/app/program.hpp"

namespace grainproof::testing {
namespace {

report::SavedCheckpoint some_checkpoint() {
  report::SavedCheckpoint saved;
  saved.origin = {"drum", {{"particles", 0xfedcba9876543210u}, {"walls", 7}}, {.engine = "reference"}};
  State& state = saved.checkpoint.state;
  state = {.step = 12, .time = 0.1, .ids = {3, 8}, .position = {{1, 2, 3}, {0.1, -0.0, 1e-310}}};
  state.velocity = {{-1, 5e300, 0}, {4, 5, 6}};
  state.angular_velocity = {{7, 8, 9}, {1, 1, 1}};
  state.orientation = {Quaternion(0.5, 0.5, -0.5, 0.5), Quaternion::Identity()};
  state.contacts = {{3, 8, 0, {1e-6, 2e-6, 0}, 1e-5, {0, 0, 1e-9}}, {8, -2, 0, {1e-7, 0, 0}}};
  saved.checkpoint.ledger.emplace();
  saved.checkpoint.ledger->kinetic = 1.5;
  saved.checkpoint.ledger->gravity_work = -2.5;
  saved.checkpoint.ledger->wall_impulses = {{1, 2, 3}};
  saved.checkpoint.ledger->wall_angular_impulses = {{4, 5, 6}};
  saved.checkpoint.maker = "reference";
  pack(saved.checkpoint.own, "numbers", std::vector<double>{1.0, 2.0});
  pack(saved.checkpoint.own, "nothing", std::vector<double>{});
  return saved;
}

std::string refusal(const std::filesystem::path& path) {
  try {
    report::read_checkpoint(path);
  } catch (const InputRefused& refused) {
    return refused.what();
  }
  return "it was taken";
}

TEST(CheckpointFile, GivesBackEveryBit) {
  const Scratch scratch;
  const auto written = some_checkpoint();
  report::write_checkpoint(scratch.path("a/b/checkpoint.h5"), written);
  const auto read = report::read_checkpoint(scratch.path("a/b/checkpoint.h5"));
  EXPECT_EQ(read.origin.scene, "drum");
  EXPECT_EQ(read.origin.parts, written.origin.parts);
  const State &one = written.checkpoint.state, &other = read.checkpoint.state;
  EXPECT_EQ(other.step, 12);
  EXPECT_EQ(other.time, 0.1);
  EXPECT_EQ(other.ids, one.ids);
  EXPECT_EQ(other.position, one.position);
  EXPECT_TRUE(std::signbit(other.position[1].y()));
  EXPECT_EQ(other.velocity, one.velocity);
  EXPECT_EQ(other.angular_velocity, one.angular_velocity);
  EXPECT_EQ(other.orientation[0].coeffs(), one.orientation[0].coeffs());
  ASSERT_EQ(other.contacts.size(), 2u);
  EXPECT_EQ(other.contacts[0].tangential_displacement, one.contacts[0].tangential_displacement);
  EXPECT_EQ(other.contacts[0].rolling_torque, one.contacts[0].rolling_torque);
  EXPECT_EQ(other.contacts[0].overlap, one.contacts[0].overlap);
  EXPECT_EQ(other.contacts[1].second, -2);
  EXPECT_EQ(numbers_of(*read.checkpoint.ledger), numbers_of(*written.checkpoint.ledger));
  EXPECT_EQ(read.checkpoint.maker, "reference");
  EXPECT_EQ(read.checkpoint.own, written.checkpoint.own);
}

TEST(CheckpointFile, IsRefusedWithItsReason) {
  const Scratch scratch;
  const auto path = scratch.path("checkpoint.h5");
  EXPECT_NE(refusal(path).find("is not there"), std::string::npos);
  EXPECT_NE(refusal(scratch.path(".")).find("no file"), std::string::npos);
  EXPECT_NE(refusal(scratch.file("empty", "")).find("is not a grainproof checkpoint"), std::string::npos);
  EXPECT_NE(refusal(scratch.file("foreign", "\x89HDF\r\n\x1a\n of somebody else")).find("is not a"),
            std::string::npos);
  const std::string later = "grainproof checkpoint layout 2 bytes 9 hash 1\n";
  EXPECT_NE(refusal(scratch.file("later", later)).find("layout 2; this program reads layout 1"),
            std::string::npos);
}

TEST(CheckpointFile, IsRefusedWhereverItIsCutOrChanged) {
  const Scratch scratch;
  const auto path = scratch.path("checkpoint.h5");
  report::write_checkpoint(path, some_checkpoint());
  const std::string whole = text_of(path);
  for (std::size_t kept = 600; kept < whole.size(); kept += 701) {
    scratch.file("cut", whole.substr(0, kept));
    EXPECT_NE(refusal(scratch.path("cut")).find("truncated"), std::string::npos) << kept;
  }
  for (std::size_t at = 512; at < whole.size(); at += 97) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    scratch.file("changed", changed);
    EXPECT_NE(refusal(scratch.path("changed")).find("damaged"), std::string::npos) << at;
  }
}

TEST(CheckpointFile, OfAnotherSceneIsRefusedByNameOrPart) {
  const report::CheckpointOrigin origin = some_checkpoint().origin;
  EXPECT_NO_THROW(report::require_same_scene("c.h5", origin, "drum", origin.parts));
  try {
    report::require_same_scene("c.h5", origin, "drum", {{"particles", 0xfedcba9876543210u}, {"walls", 8}});
    FAIL() << "it was taken";
  } catch (const InputRefused& refused) {
    EXPECT_STREQ(refused.what(), "c.h5 was written by a run of another version of drum; what differs: walls");
  }
  EXPECT_THROW(report::require_same_scene("c.h5", origin, "hopper", {{"flow", 1}}), InputRefused);
}

}  // namespace
}  // namespace grainproof::testing
