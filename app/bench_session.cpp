// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench_session.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "app/engines.hpp"
#include "app/resources.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"
#include "opencl/engine.hpp"
#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

namespace fs = std::filesystem;

fs::path programs_folder() {
  const fs::path own = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder :
       {own.parent_path() / "benchmarks", own.parent_path() / "libexec" / "grainproof"})
    if (fs::exists(folder / "bench_scaling")) return folder;
  throw InputRefused("the benchmark programs are not beside " + own.string() +
                     "; build the target benchmarks/all, or install with GRAINPROOF_BENCHMARKS=ON");
}

/// In a source tree beside its builds, elsewhere where a user's caches are.
fs::path usual_cache() {
  const fs::path data = data_root();
  if (fs::is_directory(data / "build")) return data / "build" / "cache";
  if (const char* folder = std::getenv("XDG_CACHE_HOME")) return fs::path(folder) / "grainproof";
  const char* home = std::getenv("HOME");
  return (home ? fs::path(home) / ".cache" : fs::temp_directory_path()) / "grainproof";
}

std::vector<std::string> engines_here(const BenchOptions& options) {
  std::vector<std::string> names;
  const std::vector<std::string> wanted =
      options.engines.empty() ? std::vector<std::string>{"reference", "opencl:single", "opencl:double"}
                              : options.engines;
  for (const std::string& name : wanted)
    for (const Made& made : make_engines(name, {data_root(), "", options.device}))
      if (made.engine) names.push_back(made.name);
  if (names.empty()) throw InputRefused("none of the engines asked for is available; see grainproof doctor");
  return names;
}

bool runs_on_processor(const std::string& device) {
  const auto devices = opencl::list_devices();
  return std::none_of(devices.begin(), devices.end(), [&](const opencl::DeviceDescription& one) {
    return one.gpu && (device.empty() || one.name.find(device) != std::string::npos);
  });
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

/// Each line of a command's output as it comes. Returns the exit status.
int each_line(const std::vector<std::string>& words, const fs::path& errors,
              const std::function<void(const std::string&)>& seen) {
  std::string command;
  for (const std::string& word : words) command += quoted(word) + " ";
  FILE* output = popen((command + "2>" + quoted(errors.string())).c_str(), "r");
  if (output == nullptr) throw EngineFailed("cannot start " + words.front());
  std::string line;
  for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output)) {
    if (c != '\n') {
      line += static_cast<char>(c);
      continue;
    }
    seen(line);
    line.clear();
  }
  return pclose(output);
}

}  // namespace

BenchSession::BenchSession(const BenchOptions& options, Progress& progress)
    : options_(options),
      progress_(progress),
      programs_(programs_folder()),
      cache_(options.cache.empty() ? usual_cache() : fs::absolute(options.cache)),
      engines_(engines_here(options)),
      on_processor_(runs_on_processor(options.device)) {}

std::vector<std::string> BenchSession::engines_in_every_precision() const {
  std::vector<std::string> engines = engines_;
  const auto single = std::find(engines.begin(), engines.end(), "opencl:single");
  if (options_.engines.empty() && single != engines.end()) engines.insert(single + 1, "opencl:mixed");
  return engines;
}

std::vector<std::string> BenchSession::command(const BenchRun& what, const fs::path& json) const {
  const int rounds = options_.rounds > 0 ? options_.rounds : what.rounds;
  const double seconds = options_.seconds > 0.0 ? options_.seconds : what.seconds;
  std::vector<std::string> words{(programs_ / ("bench_" + what.suite)).string(),
                                 "--benchmark_out_format=json", "--benchmark_out=" + json.string(),
                                 "--benchmark_color=false", "--cache=" + cache_.string()};
  const auto option = [&](const std::string& name, const std::string& value) {
    if (!value.empty()) words.push_back("--" + name + "=" + value);
  };
  std::vector<std::string> sizes;
  for (std::int64_t size : what.particles) sizes.push_back(std::to_string(size));
  option("device", options_.device);
  option("scenes", joined(what.scenes));
  option("engines", joined(what.engines));
  option("particles", joined(sizes));
  option("threads", what.threads > 0 ? std::to_string(what.threads) : "");
  option("rounds", rounds > 0 ? std::to_string(rounds) : "");
  option("seconds", seconds > 0.0 ? report::exact(seconds) : "");
  if (options_.quick) words.emplace_back("--quick");
  return words;
}

void BenchSession::follow(const std::string& line, const std::string& what, std::size_t& done,
                          std::size_t total) {
  if (line.starts_with("note: ")) progress_.say(line.substr(6));
  if (line.find("/iterations:") == std::string::npos) return;
  ++done;
  progress_.show(what, static_cast<double>(done) / static_cast<double>(std::max(total, done)));
}

std::vector<Sample> BenchSession::run(const BenchRun& what) {
  const TemporaryFolder folder;
  const std::vector<std::string> words = command(what, folder.path() / "report.json");
  std::vector<std::string> listing = words;
  listing.emplace_back("--benchmark_list_tests=true");
  std::size_t total = 0;
  each_line(listing, folder.path() / "errors", [&](const std::string&) { ++total; });
  if (!progress_.on_terminal()) progress_.say(what.suite + ": " + what.what + " …");
  progress_.begin();
  progress_.show(what.suite + ": " + what.what, 0.0);
  std::size_t done = 0;
  const int status = each_line(words, folder.path() / "errors", [&](const std::string& line) {
    follow(line, what.suite + ": " + what.what, done, total);
  });
  progress_.clear();
  if (status != 0)
    throw EngineFailed("the benchmark program of " + what.suite + " failed:\n" +
                       last_lines(folder.path() / "errors", 5));
  std::ifstream report(folder.path() / "report.json");
  const std::vector<Sample> found = samples_of(nlohmann::json::parse(report));
  samples_.insert(samples_.end(), found.begin(), found.end());
  has_more();
  return found;
}

void BenchSession::leave_out(Sample subject, const std::string& because) {
  progress_.say(subject.subject() + " " + because);
  subject.error = because;
  samples_.push_back(std::move(subject));
}

}  // namespace grainproof::app
