// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/peers/script_engine.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <utility>

#include "comparisons/peers/deck.hpp"
#include "comparisons/peers/dump.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"

namespace grainproof::peers {
namespace {

constexpr std::size_t batch_scenes = 512;
constexpr std::size_t particles_worth_processes = 1000;
constexpr double half_ulp = 0x1p-53;

/// Scenes that the deck got through before the program ended.
std::size_t scenes_through(const std::filesystem::path& output) {
  std::ifstream in(output);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line);) count += line == done_marker(static_cast<int>(count));
  return count;
}

/// What the program says of an error, and what was printed last.
std::string complaint_in(const std::filesystem::path& output) {
  std::ifstream in(output);
  std::string text;
  for (std::string line; std::getline(in, line);)
    if (line.find("ERROR") != std::string::npos) text.append(line).append(1, '\n');
  return text.empty() ? last_lines(output, 5) : text;
}

/// Errors by which it says that the physics, not the deck, is at fault.
bool is_runaway(const std::string& complaint) {
  for (const char* sign : {"Non-numeric", "non-numeric", "unstable", "Lost atoms"})
    if (complaint.find(sign) != std::string::npos) return true;
  return false;
}

}  // namespace

ScriptEngine::ScriptEngine(Dialect dialect, ProgramOptions options)
    : dialect_(std::move(dialect)),
      options_(std::move(options)),
      installed_(find_program(options_.program).has_value()) {}

std::string ScriptEngine::version_in(const std::filesystem::path& output) const {
  std::ifstream in(output);
  std::string line;
  std::getline(in, line);
  const std::string& before = dialect_.version_before;
  const std::size_t from = line.find(before);
  const std::size_t to = line.find_first_of(",)", from);
  return from == std::string::npos ? "" : line.substr(from + before.size(), to - from - before.size());
}

Provenance ScriptEngine::provenance_of(const Scene& scene, const std::string& version) const {
  return {dialect_.name, "double", "", version, dialect_.variant(scene), half_ulp};
}

Support ScriptEngine::supports(const Scene& scene, const Request& request) const {
  if (!installed_)
    return Support::no(options_.program + " is not installed (Debian package " + dialect_.package + ")");
  return dialect_.expressible(scene, request);
}

Observations ScriptEngine::observe(const Scene& scene, const Request& request) {
  return std::move(observe_all({&scene, 1}, request).front());
}

std::vector<Observations> ScriptEngine::observe_all(std::span<const Scene> scenes, const Request& request) {
  for (const Scene& scene : scenes)
    if (const Support support = supports(scene, request); !support) throw EngineFailed(support.because);
  std::vector<Observations> all;
  while (all.size() < scenes.size()) {
    const auto batch = scenes.subspan(all.size(), std::min(batch_scenes, scenes.size() - all.size()));
    for (Observations& seen : observe_batch(batch, request)) all.push_back(std::move(seen));
  }
  return all;
}

std::vector<std::string> ScriptEngine::command(std::span<const Scene> scenes) const {
  std::vector<std::string> words;
  if (options_.processes > 1 && scenes.front().particles.size() >= particles_worth_processes)
    words = {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", std::to_string(options_.processes)};
  // without stdbuf what is said last is lost, since LIGGGHTS aborts with its output still buffered
  for (const char* word : {"stdbuf", "-oL", options_.program.c_str(), "-in", "deck", "-log", "none"})
    words.emplace_back(word);
  return words;
}

/// May return fewer than asked for: after a scene that made the program stop, which then is the last.
std::vector<Observations> ScriptEngine::observe_batch(std::span<const Scene> scenes,
                                                      const Request& request) const {
  const TemporaryFolder folder;
  std::ofstream deck(folder.path() / "deck");
  for (std::size_t i = 0; i < scenes.size(); ++i)
    deck << dialect_.deck(scenes[i], request, folder.path(), static_cast<int>(i));
  deck.close();
  const std::filesystem::path output = folder.path() / "output";
  const auto began = std::chrono::steady_clock::now();
  const int status = run_program(command(scenes), folder.path(), output);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  const std::size_t through = scenes_through(output);
  const bool stopped = through < scenes.size();
  const std::string complaint = stopped ? complaint_in(output) : "";
  if (stopped && !is_runaway(complaint))
    throw EngineFailed(dialect_.called + " ended with status " + std::to_string(status) + " in scene " +
                       std::to_string(through) + " of " + std::to_string(scenes.size()) + ":\n" + complaint);
  const std::string version = version_in(output);
  std::vector<Observations> all;
  for (std::size_t i = 0; i < through; ++i) {
    all.push_back(read_dump(folder.path() / dump_name(static_cast<int>(i)), scenes[i],
                            sample_steps(scenes[i], request), dialect_.called));
    all.back().provenance = provenance_of(scenes[i], version);
    all.back().wall_s = wall_s / static_cast<double>(scenes.size());
  }
  if (!stopped) return all;
  all.emplace_back().outcome = {Outcome::Status::went_wrong, complaint, 0, 0.0, {}};
  all.back().provenance = provenance_of(scenes[through], version);
  return all;
}

}  // namespace grainproof::peers
