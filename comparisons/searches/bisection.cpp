// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/searches/bisection.hpp"

#include <sstream>

namespace grainproof {
namespace {

constexpr int most_widenings = 12;  // each squares the ratio: from 2 % to a factor of 10^35

struct Bracket {
  double low;
  double high;
  bool low_holds = false;
  bool high_holds = false;
  int widenings = 0;
  std::string because;

  bool narrower_than(double accuracy) const {
    return low_holds && high_holds && high - low <= accuracy * low;
  }
  double next() const { return !low_holds ? low : !high_holds ? high : 0.5 * (low + high); }

  void learn(double at, const Side& side) {
    because = side.because;
    const double ratio = high / low;
    if (side.above) {
      high = at;
      high_holds = true;
      if (low_holds) return;
      low = high / (ratio * ratio);
    } else {
      low = at;
      low_holds = true;
      if (high_holds || at < high) return;
      high = low * ratio * ratio;
    }
    if (++widenings > most_widenings) because = no_threshold();
  }

  std::string no_threshold() const {
    std::ostringstream text;
    text << "no threshold found down to " << low << " or up to " << high;
    return text.str();
  }
};

}  // namespace

std::vector<Measured> bisect(std::span<const double> guesses, double spread, double accuracy,
                             const AskSides& ask) {
  std::vector<Bracket> brackets;
  for (const double guess : guesses)
    brackets.push_back({guess / (1.0 + spread), guess * (1.0 + spread), {}, {}, 0, {}});
  while (true) {
    std::vector<Trial> trials;
    for (std::size_t i = 0; i < brackets.size(); ++i)
      if (brackets[i].because.empty() && !brackets[i].narrower_than(accuracy))
        trials.push_back({i, brackets[i].next()});
    if (trials.empty()) break;
    const std::vector<Side> sides = ask(trials);
    for (std::size_t k = 0; k < trials.size(); ++k) brackets[trials[k].unknown].learn(trials[k].at, sides[k]);
  }
  std::vector<Measured> thresholds;
  for (const Bracket& bracket : brackets)
    thresholds.push_back(bracket.because.empty() ? Measured::of(0.5 * (bracket.low + bracket.high))
                                                 : Measured::none(bracket.because));
  return thresholds;
}

}  // namespace grainproof
