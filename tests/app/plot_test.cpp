// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/plot.hpp"

#include <gtest/gtest.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <limits>
#include <sstream>

#include "report/convergence.hpp"
#include "report/html.hpp"
#include "tests/app/rows.hpp"

namespace grainproof::testing {
namespace {

const std::vector<Row> rows{step_row("reference", "contact/8", 0.1, 0.2),
                            step_row("reference", "contact/16", 0.05, 0.075), order_row("reference", 1.02)};

report::Plot plot_of(const std::vector<Row>& some) {
  return report::convergence_plot("bounce", report::read_together(some).claims.at(0));
}

/// The lines of the picture as pairs of pixels.
std::vector<std::vector<std::pair<double, double>>> drawn_lines(const std::string& svg) {
  std::istringstream stream(svg);
  boost::property_tree::ptree tree;
  read_xml(stream, tree);
  std::vector<std::vector<std::pair<double, double>>> lines;
  for (const auto& [tag, element] : tree.get_child("svg")) {
    if (tag != "polyline") continue;
    std::istringstream points(element.get<std::string>("<xmlattr>.points"));
    auto& line = lines.emplace_back();
    char comma = 0;
    for (double x = 0, y = 0; points >> x >> comma >> y;) line.emplace_back(x, y);
  }
  return lines;
}

TEST(ConvergencePlot, JoinsJudgedStepsAndThePointsOfTheOrder) {
  const auto plot = plot_of(rows);
  ASSERT_EQ(plot.series.size(), 1U);
  ASSERT_EQ(plot.series[0].points.size(), 3U) << "contact/32 is known from the order alone";
  EXPECT_NEAR(plot.series[0].points[0].first, 1.0 / 32.0, 1e-15);
  EXPECT_EQ(plot.series[0].points[0].second, 0.025);
  EXPECT_EQ(plot.series[0].bounds.size(), 2U);
  EXPECT_EQ(plot.x_title, "step / contact time");
}

TEST(ConvergencePlot, DrawsAPowerLawAsAStraightLine) {
  const auto lines = drawn_lines(report::svg(plot_of(rows)));
  ASSERT_EQ(lines.size(), 1U);
  ASSERT_EQ(lines[0].size(), 3U);
  const auto slope = [&](int i) {
    return (lines[0][i + 1].second - lines[0][i].second) / (lines[0][i + 1].first - lines[0][i].first);
  };
  EXPECT_LT(slope(0), 0.0) << "a smaller step has a smaller error; pixels count downwards";
  EXPECT_NEAR(slope(0), slope(1), 0.01);
}

TEST(ConvergencePlot, LeavesOutWhatALogarithmCannotShow) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto plot =
      plot_of({step_row("reference", "contact/8", nan, 0.2), step_row("reference", "contact/16", 0.0, 0.1)});
  EXPECT_FALSE(plot.worth_drawing());
  EXPECT_EQ(report::svg(plot_of({step_row("reference", "contact/8", nan, 0.2),
                                 step_row("reference", "contact/16", 0.1, 0.1)}))
                .find("nan"),
            std::string::npos);
}

TEST(ConvergencePlot, ReadsStepsInSeconds) {
  const auto plot =
      plot_of({step_row("reference", "1e-3", 0.1, 0.2), step_row("reference", "5e-4", 0.05, 0.1)});
  EXPECT_EQ(plot.x_title, "step / s");
  EXPECT_EQ(plot.series[0].points.front().first, 5e-4);
}

TEST(HtmlReport, EscapesWhatCasesAndEnginesAreCalled) {
  std::vector<Row> odd = rows;
  for (Row& row : odd) row.engine = "external:<b> & \"c\"";
  const std::string page = report::html({{"a < b", odd}}, {});
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("external:&lt;b&gt; &amp; &quot;c&quot;"), std::string::npos);
  EXPECT_NE(page.find("a &lt; b"), std::string::npos);
}

}  // namespace
}  // namespace grainproof::testing
