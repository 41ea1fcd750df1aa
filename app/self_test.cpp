// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/self_test.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <span>
#include <sstream>
#include <vector>

#include "analytic/closed_forms.hpp"
#include "app/resources.hpp"
#include "input/read_case.hpp"
#include "model/errors.hpp"
#include "opencl/engine.hpp"
#include "report/files.hpp"
#include "report/numbers.hpp"
#include "report/run_summary.hpp"

namespace grainproof::app {
namespace fs = std::filesystem;
namespace {

/// Gravity alone; a dashpot; friction that turns a sphere.
constexpr std::array cases{"free_fall", "normal_collision", "sliding_to_rolling"};

/// Of the largest speed: the finest step of these cases errs by less, and no broken kernel by as little.
constexpr double tolerance = 0.01;

std::uint64_t hashed(std::uint64_t hash, const std::string& text) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return hash;
}

std::uint64_t hash_of_kernels(const fs::path& kernels, std::uint64_t hash) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kernels)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    hash = hashed(hashed(hash, file.filename().string()), text.str());
  }
  return hash;
}

fs::path cache_folder() {
  const auto named = [](const char* name) -> fs::path {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
  };
  if (const fs::path cache = named("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "grainproof" / "self-test";
  if (const fs::path home = named("HOME"); home.is_absolute())
    return home / ".cache" / "grainproof" / "self-test";
  return {};
}

/// Where a pass is remembered; empty where there is no folder for it.
fs::path mark_of(const Provenance& of, const fs::path& kernels) {
  const fs::path folder = cache_folder();
  if (folder.empty()) return {};
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const std::string& text : {std::string(GRAINPROOF_VERSION), of.device, of.version, of.precision})
    hash = hashed(hash, text + "\n");
  return folder / report::digest_text(hash_of_kernels(kernels, hash));
}

Scene finest_scene(const fs::path& data, const std::string& name) {
  Scene scene = read_case(find_case(data, name), {}).scenes.back().scene;
  scene.run.integrator = Integrator::velocity_verlet;  // so that all are run by one program
  scene.run.sample_times = {0.0, scene.run.end};
  return scene;
}

/// The largest difference of a velocity, of a centre or of a turning surface, over the largest speed.
double error_of(const Scene& scene, const Frame& seen, const Frame& exact) {
  double fastest = 0.0, error = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double radius = scene.particles[i].diameter / 2.0;
    fastest = std::max({fastest, exact.velocity[i].norm(), scene.particles[i].velocity.norm()});
    error = std::max(error, (seen.velocity[i] - exact.velocity[i]).norm());
    if (!exact.angular_velocity.empty())
      error = std::max(error, radius * (seen.angular_velocity[i] - exact.angular_velocity[i]).norm());
  }
  return error / fastest;
}

void run_cases(opencl::OpenClEngine& engine, std::span<const char* const> names, const fs::path& data,
               const std::string& path) {
  for (const char* name : names) {
    const Scene scene = finest_scene(data, name);
    const Observations seen = engine.observe(scene, {});
    const Observations exact = analytic::make_analytic_engine()->observe(scene, {});
    const bool ended = seen.outcome.status == Outcome::Status::completed;
    const double error = ended ? error_of(scene, seen.frames.back(), exact.frames.back()) : 1.0;
    if (error < tolerance) continue;
    throw EngineFailed("the kernels do not compute on " + engine.provenance().device +
                       " what they should: " + name + " on the " + path + " path is off by " +
                       report::brief(error) + " of its speed, " + report::brief(tolerance) + " is allowed" +
                       (ended ? "" : "; " + seen.outcome.reason) + "; --no-self-test runs all the same");
  }
}

void remember(const fs::path& mark, const Provenance& of) {
  try {
    report::write_file(mark, of.device + ", " + of.version + ", " + of.precision + " precision: passed\n");
  } catch (const fs::filesystem_error&) {
    // A cache that cannot be written costs a self-test the next time, and nothing else.
  }
}

}  // namespace

void require_sound_kernels(const Engine& engine, const fs::path& data, const std::string& device,
                           Progress& progress) {
  const auto* opencl = dynamic_cast<const opencl::OpenClEngine*>(&engine);
  if (opencl == nullptr) return;
  const Provenance of = opencl->provenance();
  const fs::path mark = mark_of(of, data / "kernels");
  std::error_code ignored;
  if (!mark.empty() && fs::exists(mark, ignored)) return;
  progress.say("testing the kernels on " + of.device + " …");
  const auto run_on = [&](opencl::Path path, const std::string& name, std::span<const char* const> asked) {
    opencl::EngineOptions options;
    options.precision = opencl::precision_named(of.precision).value();
    options.device = device;
    options.kernels = data / "kernels";
    options.path = path;
    opencl::OpenClEngine tested(options);
    run_cases(tested, asked, data, name);
  };
  // A program takes seconds to compile where the device's cache does not have it: the zoned path is asked for
  // one case, whose program has most of the stages.
  run_on(opencl::Path::small, "small", cases);
  run_on(opencl::Path::zoned, "zoned", std::span(cases).last(1));
  // It shares no law with the others: a pair and a wall.
  run_on(opencl::Path::dense, "dense", std::span(cases).last(2));
  if (!mark.empty()) remember(mark, of);
}

}  // namespace grainproof::app
