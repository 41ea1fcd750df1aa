// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/engine.hpp"

#include <algorithm>
#include <limits>
#include <mutex>

#include "model/errors.hpp"
#include "opencl/dense_run.hpp"
#include "opencl/limits.hpp"
#include "opencl/skin_search.hpp"
#include "opencl/small_run.hpp"
#include "opencl/workshop.hpp"
#include "opencl/zoned_run.hpp"

namespace grainproof::opencl {
namespace {

bool takes_small_path(Path path, const Scene& scene) {
  if (path == Path::automatic) return scene.particles.size() <= SmallRun::most_particles;
  return path == Path::small;
}

/// Fewer are not worth the sorting.
constexpr std::size_t fewest_dense = 512;

/// Throws EngineFailed where the dense path is asked for and cannot be had.
bool takes_dense_path(Path path, const Scene& scene, const Request& request, double skin, bool one) {
  if (path != Path::dense && path != Path::automatic) return false;
  if (path == Path::automatic && scene.particles.size() < fewest_dense) return false;
  const Support support = dense_support(scene, request, skin, one);
  if (path == Path::dense && !support)
    throw EngineFailed("the dense path cannot take it: " + support.because);
  return support.yes;
}

/// A contact that ends is heard of while its pair is listed, so a list may not end where contacts do. A pair
/// that parts by more than this in one step loses the correction alone.
double skin_for_endings(const Scene& scene, double skin) {
  if (scene.run.integrator != Integrator::onset_corrected) return skin;
  double smallest = std::numeric_limits<double>::max();
  for (const Particle& p : scene.particles) smallest = std::min(smallest, p.diameter);
  return scene.particles.empty() ? skin : std::max(skin, 0.1 * smallest);
}

/// A tenth of the mean diameter: the usual compromise between long lists and frequent ones.
double given_or_usual_skin(const Scene& scene) {
  if (scene.run.skin >= 0.0) return scene.run.skin;
  double sum = 0.0;
  for (const Particle& p : scene.particles) sum += p.diameter;
  return scene.particles.empty() ? 0.0 : 0.1 * sum / static_cast<double>(scene.particles.size());
}

}  // namespace

OpenClEngine::OpenClEngine(EngineOptions options)
    : options_(std::move(options)),
      workshop_(std::make_shared<Workshop>(options_.device, options_.kernels)) {}

OpenClEngine::~OpenClEngine() = default;

std::string OpenClEngine::name() const {
  return "opencl:" + std::string(name_of(options_.precision));
}

Support OpenClEngine::supports(const Scene& scene, const Request& request) const {
  if (needs_doubles(options_.precision) && !workshop_->has_double_precision())
    return Support::no("the device " + workshop_->device_name() + " has no double precision");
  if (const Support composed =
          composition_within_limits(scene, request, takes_small_path(options_.path, scene));
      !composed)
    return composed;
  return within_limits(scene, options_.precision);
}

std::unique_ptr<Run> OpenClEngine::start(const Scene& scene, const Request& request) {
  const Support support = supports(scene, request);
  if (!support) throw EngineFailed(name() + " does not support this scene: " + support.because);
  return begin(scene, request);
}

double OpenClEngine::skin_of(const Scene& scene) const {
  const double wanted =
      searches_skin(scene) ? first_skin(scene) : options_.skin.value_or(given_or_usual_skin(scene));
  return skin_for_endings(scene, wanted);
}

bool OpenClEngine::searches_skin(const Scene& scene) const {
  return !options_.skin && scene.run.skin == RunSettings::searched_skin;
}

Path OpenClEngine::path_of(const Scene& scene, const Request& request) const {
  if (takes_small_path(options_.path, scene)) return Path::small;
  const bool one = takes_one(options_.width, workshop_->is_gpu());
  return takes_dense_path(options_.path, scene, request, skin_of(scene), one) ? Path::dense : Path::zoned;
}

std::unique_ptr<RestorableRun> OpenClEngine::begin(const Scene& scene, const Request& request) {
  const Path path = path_of(scene, request);
  const bool searched = searches_skin(scene), small = path == Path::small;
  const double skin = skin_of(scene);
  const bool one = takes_one(options_.width, workshop_->is_gpu());
  if (path == Path::dense)
    return std::make_unique<DenseRun>(workshop_, scene, dense_options(scene, options_.precision, one), skin,
                                      searched ? std::optional(skin_for_endings(scene, 0.0)) : std::nullopt);
  BuildOptions build = build_options(scene, request, options_.precision, small);
  if (options_.stages == Stages::full) build = with_every_stage(build);
  if (small) return std::make_unique<SmallRun>(workshop_, scene, build);
  return std::make_unique<ZonedRun>(workshop_, scene, build, choose_zones(scene, skin),
                                    static_cast<std::size_t>(options_.work_group));
}

// A workshop's queue, programs and kernel arguments belong to one run at a time, and drivers that compile on
// the processor are not all made for threads.
Observations OpenClEngine::observe(const Scene& scene, const Request& request) {
  static std::mutex turn;
  const std::lock_guard lock(turn);
  return SteppingEngine::observe(scene, request);
}

std::unique_ptr<RestartableRun> OpenClEngine::go_on(const Scene& scene, const Request& request,
                                                    const Beginning& beginning) {
  std::unique_ptr<RestorableRun> run = begin(scene, request);
  run->begin_at(beginning);
  return run;
}

std::unique_ptr<RestartableRun> OpenClEngine::restored(const Scene& scene, const Request& request,
                                                       const Checkpoint& from, std::string& because) {
  std::unique_ptr<RestorableRun> run = begin(scene, request);
  if (from.maker != run->maker())
    because = "it was written by " +
              (from.maker.empty() ? "an engine without a part of its own" : from.maker) +
              ", and this run is " + run->maker();
  else if (request.ledger && !from.ledger)
    because = "it was written by a run without a ledger";
  else
    run->restore(from.own);
  if (!because.empty()) return nullptr;
  return run;
}

Provenance OpenClEngine::provenance() const {
  Provenance p;
  p.engine = "opencl";
  p.precision = std::string(name_of(options_.precision));
  p.device = workshop_->device_name();
  p.version = workshop_->version();
  p.unit_roundoff = options_.precision == Precision::double_precision ? 0x1p-53 : 0x1p-24;
  return p;
}

}  // namespace grainproof::opencl
