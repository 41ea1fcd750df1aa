// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_sample.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>
#include <sstream>
#include <stdexcept>

namespace grainproof::app {
namespace {

using nlohmann::json;

/// What Google Benchmark tells of every benchmark, and what is not a value of ours.
constexpr std::array not_ours{"family_index", "per_family_instance_index",
                              "repetitions",  "repetition_index",
                              "threads",      "iterations",
                              "real_time",    "cpu_time"};

bool is_ours(const std::string& name, const json& value) {
  return value.is_number() && std::find(not_ours.begin(), not_ours.end(), name) == not_ours.end();
}

void read_name(const std::string& name, Sample& sample) {
  std::istringstream parts(name);
  std::string part;
  std::getline(parts, part, '/');
  sample.keys["suite"] = part;
  while (std::getline(parts, part, '/')) {
    const std::size_t colon = part.find(':');
    if (colon == std::string::npos || part.starts_with("iterations:")) continue;
    const std::string value = part.substr(colon + 1);
    if (part.starts_with("round:"))
      sample.round = std::stoi(value);
    else
      sample.keys[part.substr(0, colon)] = value;
  }
}

Sample sample_of(const json& benchmark) {
  Sample sample;
  read_name(benchmark.at("name").get<std::string>(), sample);
  for (const auto& [name, value] : benchmark.items())
    if (is_ours(name, value)) sample.values[name] = value.get<double>();
  if (const std::string because = benchmark.value("label", ""); !because.empty())
    sample.keys["because"] = because;
  if (benchmark.value("error_occurred", false)) sample.error = benchmark.value("error_message", "failed");
  return sample;
}

/// "64" is a number in a row, "bed_10k" a text.
json as_json(const std::string& text) {
  double number = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return text;
  if (number == static_cast<double>(static_cast<std::int64_t>(number)))
    return static_cast<std::int64_t>(number);
  return number;
}

json row_of(const std::vector<const Sample*>& rounds) {
  json row;
  for (const auto& [name, value] : rounds.front()->keys)
    row[name] = name == "suite" ? json(value) : as_json(value);
  std::map<std::string, std::vector<double>> values;
  for (const Sample* sample : rounds)
    for (const auto& [name, value] : sample->values)
      if (sample->error.empty()) values[name].push_back(value);
  for (const auto& [name, all] : values) row[name] = spread_of(all).median;
  if (const auto found = values.find("cundall_number"); found != values.end()) {
    row["cundall_min"] = spread_of(found->second).least;
    row["cundall_max"] = spread_of(found->second).most;
  }
  row["rounds"] = rounds.size();
  row["status"] = rounds.back()->error.empty() ? "completed" : rounds.back()->error;
  return row;
}

}  // namespace

std::string Sample::subject() const {
  std::string text;
  for (const auto& [name, value] : keys) text.append(name).append(":").append(value).append("/");
  return text;
}

std::string Sample::key(const std::string& name) const {
  const auto found = keys.find(name);
  return found == keys.end() ? "" : found->second;
}

double Sample::value(const std::string& name) const {
  const auto found = values.find(name);
  return found == values.end() ? 0.0 : found->second;
}

std::vector<Sample> samples_of(const json& report) {
  std::vector<Sample> samples;
  for (const json& benchmark : report.at("benchmarks")) samples.push_back(sample_of(benchmark));
  return samples;
}

Spread spread_of(std::vector<double> values) {
  if (values.empty()) throw std::invalid_argument("no spread of nothing");
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
  return {values.front(), median, values.back()};
}

json rows_of(const std::vector<Sample>& samples) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<const Sample*>> subjects;
  for (const Sample& sample : samples) {
    auto& rounds = subjects[sample.subject()];
    if (rounds.empty()) order.push_back(sample.subject());
    rounds.push_back(&sample);
  }
  json rows = json::array();
  for (const std::string& subject : order) rows.push_back(row_of(subjects[subject]));
  return rows;
}

std::string engine_of(const Sample& sample) {
  const std::string engine = sample.key("engine");
  return engine == "opencl" ? engine + " " + sample.key("precision") : engine;
}

std::vector<Sample> subjects(const std::vector<Sample>& samples) {
  std::vector<Sample> first;
  std::set<std::string> seen;
  for (const Sample& sample : samples)
    if (seen.insert(sample.subject()).second) first.push_back(sample);
  return first;
}

std::vector<double> ratios(const std::vector<Sample>& samples, const std::string& subject,
                           const std::string& over, const std::string& value) {
  std::map<int, double> above, below;
  for (const Sample& sample : samples) {
    if (!sample.error.empty()) continue;
    if (sample.subject() == subject) above[sample.round] = sample.value(value);
    if (sample.subject() == over) below[sample.round] = sample.value(value);
  }
  std::vector<double> found;
  for (const auto& [round, number] : above)
    if (below.contains(round)) found.push_back(number / below[round]);
  return found;
}

}  // namespace grainproof::app
