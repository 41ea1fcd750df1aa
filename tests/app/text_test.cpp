// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "report/numbers.hpp"
#include "report/text_table.hpp"

namespace grainproof::testing {
namespace {

TEST(Numbers, AreGivenToThreeDigits) {
  EXPECT_EQ(report::brief(0.0), "0");
  EXPECT_EQ(report::brief(1.0 / 3.0), "0.333");
  EXPECT_EQ(report::brief(-2.5e-4), "-2.50e-04");
  EXPECT_EQ(report::brief(999.4), "999");
  EXPECT_EQ(report::brief(12345.6), "12346");
  EXPECT_EQ(report::brief(1.5e7), "1.50e+07");
  EXPECT_EQ(report::brief(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(report::brief(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Numbers, InFullReadBackAsTheSame) {
  for (double value : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308})
    EXPECT_EQ(std::strtod(report::exact(value).c_str(), nullptr), value);
  EXPECT_EQ(report::exact(-0.0), "-0");
}

TEST(Numbers, ThatAreDurationsReadAsPeopleSayThem) {
  EXPECT_EQ(report::duration(0.0031), "3.1 ms");
  EXPECT_EQ(report::duration(0.42), "0.42 s");
  EXPECT_EQ(report::duration(59.4), "59 s");
  EXPECT_EQ(report::duration(185.0), "3 min 05 s");
  EXPECT_EQ(report::duration(7800.0), "2 h 10 min");
}

TEST(TextTable, AlignsByWhatIsSeenNotByBytes) {
  report::TextTable table({{"×"}, {"n", report::Align::right}});
  table.add({"µ ± 1", "10"});
  table.add({report::Paint{true}.red("bad"), "9"});
  EXPECT_EQ(table.text({}), "×       n\nµ ± 1  10\n\033[1;31mbad\033[0m     9\n");
}

TEST(Paint, LeavesTextAloneWhereThereIsNoTerminal) {
  EXPECT_EQ(report::Paint{false}.red("FAIL"), "FAIL");
  EXPECT_EQ(report::Paint{true}.red("FAIL"), "\033[1;31mFAIL\033[0m");
}

}  // namespace
}  // namespace grainproof::testing
