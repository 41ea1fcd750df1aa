// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/bench.hpp"
#include "app/bench_sample.hpp"
#include "app/progress.hpp"

namespace grainproof::app {

/// What one run of a benchmark program is asked for; what is empty or zero is left to the program.
struct BenchRun {
  std::string suite;
  std::string what;  ///< for the progress
  std::vector<std::string> scenes = {};
  std::vector<std::string> engines = {};
  std::vector<std::int64_t> particles = {};
  int threads = 0;
  int rounds = 0;        ///< unless the user says otherwise
  double seconds = 0.0;  ///< likewise
};

/// Runs benchmark programs one after the other and gathers what they measure.
class BenchSession {
 public:
  BenchSession(const BenchOptions& options, Progress& progress);

  /// The samples of this run; all() holds them too. Throws EngineFailed with what the program said last.
  std::vector<Sample> run(const BenchRun& what);

  /// A row that says why something was not measured.
  void leave_out(Sample subject, const std::string& because);

  const BenchOptions& options() const { return options_; }
  bool quick() const { return options_.quick; }
  Progress& progress() { return progress_; }
  /// Those of our engines that are here and asked for: "reference", "opencl:single", …
  const std::vector<std::string>& engines() const { return engines_; }
  /// With mixed precision too, which other suites measure only where it is named.
  std::vector<std::string> engines_in_every_precision() const;
  /// Whether OpenCL runs on a processor, whose threads can be limited.
  bool on_processor() const { return on_processor_; }
  const std::vector<Sample>& all() const { return samples_; }

  /// Beside the rows: "fits", "ratios".
  nlohmann::json extra = nlohmann::json::object();
  /// Called when a program has measured something, so that what there is can be kept.
  std::function<void()> has_more = [] {};

 private:
  std::vector<std::string> command(const BenchRun& what, const std::filesystem::path& json) const;
  void follow(const std::string& line, const std::string& what, std::size_t& done, std::size_t total);

  const BenchOptions& options_;
  Progress& progress_;
  std::filesystem::path programs_;
  std::filesystem::path cache_;
  std::vector<std::string> engines_;
  bool on_processor_ = true;
  std::vector<Sample> samples_;
};

}  // namespace grainproof::app
