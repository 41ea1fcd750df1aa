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
#include "reference_cpu/reference_engine.hpp"
#include "report/files.hpp"
#include "report/numbers.hpp"
#include "report/run_summary.hpp"

namespace grainproof::app {
namespace fs = std::filesystem;
namespace {

/// A case, and whether it takes few steps a contact and is held against the reference's same steps: what
/// corrects a contact's beginning and end is large then, and closed forms are far away.
struct Trial {
  const char* scene;
  bool coarse = false;
};

/// Gravity alone; a dashpot; friction that turns a sphere; two spheres that meet askew, spinning, and one
/// that strikes a floor, on springs.
constexpr std::array trials{Trial{"free_fall"}, Trial{"normal_collision"}, Trial{"sliding_to_rolling"},
                            Trial{"onset_history", true}, Trial{"mfix_05_sliding", true}};

/// A program takes seconds to compile where the device's cache does not have it: the larger paths are asked
/// for cases whose programs have most of the stages. The dense one takes walls and pairs by other files.
std::span<const Trial> trials_on(opencl::Path path) {
  const std::span all(trials);
  if (path == opencl::Path::small) return all;
  return path == opencl::Path::zoned ? all.subspan(2, 2) : all.subspan(2);
}

const char* name_of(opencl::Path path) {
  return path == opencl::Path::small ? "small" : path == opencl::Path::zoned ? "zoned" : "dense";
}

/// Of the largest speed: the finest step of these cases errs by less, and no broken kernel by as little.
constexpr double tolerance = 0.01;
/// Likewise, of the same steps in single precision and in double.
constexpr double same_steps_tolerance = 1e-4;
/// From contact/64 and contact/50: sixteen and twelve steps a contact.
constexpr double coarser = 4.0;

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
fs::path mark_of(const Provenance& of, const std::string& way, const fs::path& kernels) {
  const fs::path folder = cache_folder();
  if (folder.empty()) return {};
  std::uint64_t hash = 0xcbf29ce484222325ull;
  for (const std::string& text : {std::string(GRAINPROOF_VERSION), of.device, of.version, of.precision, way})
    hash = hashed(hash, text + "\n");
  return folder / report::digest_text(hash_of_kernels(kernels, hash));
}

Scene scene_of(const fs::path& data, const Trial& trial, Integrator integrator) {
  const Case all = read_case(find_case(data, trial.scene), {});
  // One that begins well within a step, in a direction of its own.
  const auto second = [](const ResolvedScene& one) { return one.point.sample == 1; };
  Scene scene = trial.coarse ? std::ranges::find_if(all.scenes, second)->scene : all.scenes.back().scene;
  if (trial.coarse) scene.run.step *= coarser;
  scene.run.integrator = integrator;
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

Observations right_of(const Trial& trial, const Scene& scene) {
  if (!trial.coarse) return analytic::make_analytic_engine()->observe(scene, {});
  return reference::ReferenceEngine().observe(scene, {});
}

/// `way` is how the run ahead goes, in words.
void run_trial(opencl::OpenClEngine& engine, const Trial& trial, const Scene& scene, const std::string& way) {
  if (!engine.supports(scene, {})) return;  // by this integrator
  const Observations seen = engine.observe(scene, {}), right = right_of(trial, scene);
  const bool ended = seen.outcome.status == Outcome::Status::completed;
  const double error = ended ? error_of(scene, seen.frames.back(), right.frames.back()) : 1.0;
  const double allowed = trial.coarse ? same_steps_tolerance : tolerance;
  if (error < allowed) return;
  throw EngineFailed("the kernels do not compute on " + engine.provenance().device +
                     " what they should: " + trial.scene + " on " + way + " is off by " +
                     report::brief(error) + " of its speed, " + report::brief(allowed) + " is allowed" +
                     (ended ? "" : "; " + seen.outcome.reason) + "; --no-self-test runs all the same");
}

void remember(const fs::path& mark, const Provenance& of) {
  try {
    report::write_file(mark, of.device + ", " + of.version + ", " + of.precision + " precision: passed\n");
  } catch (const fs::filesystem_error&) {
    // A cache that cannot be written costs a self-test the next time, and nothing else.
  }
}

}  // namespace

void require_sound_kernels(const RunAhead& run, const fs::path& data, const std::string& device,
                           Progress& progress) {
  const auto* opencl = dynamic_cast<const opencl::OpenClEngine*>(&run.engine);
  if (opencl == nullptr || !opencl->supports(run.scene, run.request)) return;
  const Provenance of = opencl->provenance();
  opencl::EngineOptions options;
  options.precision = opencl::precision_named(of.precision).value();
  options.device = device;
  options.kernels = data / "kernels";
  options.path = opencl->path_of(run.scene, run.request);
  const Integrator integrator = run.scene.run.integrator;
  const std::string way = std::string("the ") + name_of(options.path) + " path with " +
                          std::string(grainproof::name_of(integrator));
  const fs::path mark = mark_of(of, way, options.kernels);
  std::error_code ignored;
  if (!mark.empty() && fs::exists(mark, ignored)) return;
  progress.say("testing the kernels on " + of.device + " …");
  opencl::OpenClEngine tested(options);
  for (const Trial& trial : trials_on(options.path))
    run_trial(tested, trial, scene_of(data, trial, integrator), way);
  if (!mark.empty()) remember(mark, of);
}

}  // namespace grainproof::app
