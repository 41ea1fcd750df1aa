// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace grainproof::app {

/// One measurement of a benchmark program.
struct Sample {
  std::map<std::string, std::string> keys;  ///< what was measured: "suite", "scene", "engine", …
  std::map<std::string, double> values;     ///< its counters
  int round = 0;
  std::string error;  ///< why there is none

  /// What a row is for: all keys, in one text.
  std::string subject() const;
  std::string key(const std::string& name) const;
  double value(const std::string& name) const;
};

/// From what Google Benchmark writes. A benchmark is called suite/key:value/…/round:0, its counters are the
/// values.
std::vector<Sample> samples_of(const nlohmann::json& report);

struct Spread {
  double least, median, most;
};

/// Throws std::invalid_argument for none.
Spread spread_of(std::vector<double> values);

/// One row a subject, in the order in which they first come: keys, the median of every value over the rounds,
/// the smallest and the largest Cundall number, and why there is nothing.
nlohmann::json rows_of(const std::vector<Sample>& samples);

/// "reference", "opencl single", …
std::string engine_of(const Sample& sample);

/// The first sample of each subject.
std::vector<Sample> subjects(const std::vector<Sample>& samples);

/// `value` of one subject over that of another, round by round, where both were measured.
std::vector<double> ratios(const std::vector<Sample>& samples, const std::string& subject,
                           const std::string& over, const std::string& value);

}  // namespace grainproof::app
