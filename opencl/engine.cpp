// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/engine.hpp"

#include "opencl/limits.hpp"
#include "opencl/small_run.hpp"
#include "opencl/workshop.hpp"

namespace grainproof::opencl {

OpenClEngine::OpenClEngine(EngineOptions options) : options_(std::move(options)) {
  if (options_.precision != Precision::mixed_precision)
    workshop_ = std::make_shared<Workshop>(options_.device, options_.kernels);
}

OpenClEngine::~OpenClEngine() = default;

std::string OpenClEngine::name() const {
  return "opencl:" + std::string(name_of(options_.precision));
}

Support OpenClEngine::supports(const Scene& scene, const Request&) const {
  if (options_.precision == Precision::mixed_precision)
    return Support::no("mixed precision is not built yet");
  if (options_.precision == Precision::double_precision && !workshop_->has_double_precision())
    return Support::no("the device " + workshop_->device_name() + " has no double precision");
  return within_limits(scene, options_.precision);
}

std::unique_ptr<Run> OpenClEngine::start(const Scene& scene, const Request& request) {
  const Support support = supports(scene, request);
  if (!support) throw EngineFailed(name() + " does not support this scene: " + support.because);
  BuildOptions build = build_options(scene, request, options_.precision, true);
  if (options_.stages == Stages::full) build = with_every_stage(build);
  return std::make_unique<SmallRun>(workshop_, scene, build);
}

Provenance OpenClEngine::provenance() const {
  Provenance p;
  p.engine = "opencl";
  p.precision = std::string(name_of(options_.precision));
  if (workshop_) p.device = workshop_->device_name();
  if (workshop_) p.version = workshop_->version();
  p.unit_roundoff = options_.precision == Precision::double_precision ? 0x1p-53 : 0x1p-24;
  return p;
}

}  // namespace grainproof::opencl
