// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/row_table.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "benchmarks/common/made_once.hpp"
#include "comparisons/peers/process.hpp"

namespace grainproof::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t size = 12;

MeasuredRow third_of(std::size_t row) {
  return {{{"third", static_cast<double>(row) / 3.0}}, ""};
}

/// Shows the first `shown` rows of a table whose rows are thirds; returns how many were measured for that.
int show_thirds(const fs::path& file, const std::string& stamp, std::size_t shown, std::size_t threads) {
  std::atomic<int> measured = 0;
  RowTable table("thirds", file, stamp);
  for (std::size_t row = 0; row < size; ++row)
    table.add({"row " + std::to_string(row), 1.0, [&measured, row] {
                 ++measured;
                 return third_of(row);
               }});
  for (std::size_t row = 0; row < shown; ++row)
    EXPECT_EQ(table.show(row, threads).values, third_of(row).values) << row;
  return measured;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(RowTable, GoesOnFromTheRowsThatWereKept) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "kept" / "rows";
  EXPECT_EQ(show_thirds(file, "one", 5, 0), 5);
  EXPECT_EQ(show_thirds(file, "one", size, 0), 7) << "rows that were kept were measured again, or too few";
  EXPECT_FALSE(fs::exists(file)) << "all had been shown";
  EXPECT_EQ(show_thirds(file, "one", size, 0), 12) << "it must begin anew";
}

TEST(RowTable, MeasuresAheadOnThreadsAndGivesTheSame) {
  const TemporaryFolder folder;
  EXPECT_EQ(show_thirds(folder.path() / "rows", "one", size, 3), 12);
  EXPECT_GE(show_thirds(folder.path() / "rows", "one", 1, 3), 1);
  EXPECT_LT(show_thirds(folder.path() / "rows", "one", size, 2), 12) << "none of the rows was kept";
}

TEST(RowTable, DoesNotUseWhatAnotherProgramHasLeft) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "rows";
  show_thirds(file, "one", 5, 0);
  testing::internal::CaptureStdout();
  EXPECT_EQ(show_thirds(file, "other", 5, 0), 5);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("note: thirds: 5 rows of another program"),
            std::string::npos)
      << "dropped in silence";
  EXPECT_EQ(show_thirds(file, "one", size, 0), 12) << "what `other` had begun was believed";
}

TEST(RowTable, DropsALineThatWasNotFinished) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "rows";
  show_thirds(file, "one", 5, 0);
  const std::string whole = text_of(file);
  for (const std::size_t cut :
       {whole.size() - 2, whole.size() - 10, whole.rfind('\n', whole.size() - 2) + 1}) {
    std::ofstream(file) << whole.substr(0, cut);
    EXPECT_EQ(show_thirds(file, "one", 7, 0), 3) << "cut to " << cut;
  }
}

TEST(KeptRows, TriesAgainWhatFailedAndWhatIsNoNumber) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "rows";
  const KeptRows first(file, "one");
  first.keep("failed", {{}, "no device"});
  first.keep("lost", {{{"limit", std::numeric_limits<double>::quiet_NaN()}}, ""});
  first.keep("good", {{{"limit", 0.1}}, ""});
  const KeptRows second(file, "one");
  ASSERT_EQ(second.found().size(), 1u);
  EXPECT_EQ(second.found().at("good").values.at("limit"), 0.1);
}

TEST(MadeOnce, MakesAndFailsOnce) {
  MadeOnce<int, int> squares;
  int tried = 0;
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(squares.get(3, [&] { return ++tried, 9; }), 9);
    EXPECT_THROW(squares.get(4, [&]() -> int { throw std::runtime_error(std::to_string(++tried)); }),
                 std::runtime_error);
  }
  EXPECT_EQ(tried, 2);
}

}  // namespace
}  // namespace grainproof::bench
