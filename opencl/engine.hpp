// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/checkpoint.hpp"
#include "opencl/precision.hpp"
#include "opencl/width.hpp"

namespace grainproof::opencl {

/// `automatic` takes the small path (one work-group, all pairs) up to 64 particles, the dense one for many
/// with contacts that it knows (opencl/dense_options.hpp), else the zoned one, which knows all.
enum class Path { automatic, small, zoned, dense };

/// `lean` compiles what a scene needs; `full` also every stage that cannot change its physics. Same bits.
enum class Stages { lean, full };

struct EngineOptions {
  Precision precision = Precision::double_precision;
  std::string device;  ///< index or part of a name of list_devices(); empty: first GPU, else first CPU
  std::filesystem::path kernels;  ///< folder of the .cl files
  Path path = Path::automatic;
  Width width = Width::automatic;  ///< of the dense path
  Stages stages = Stages::lean;
  int work_group = 64;         ///< work-items a group, a power of two
  std::optional<double> skin;  ///< m; overrides the scene's
};

/// One device as `doctor` lists it; its place in the list is its index.
struct DeviceDescription {
  std::string name;
  std::string platform;
  std::string version;
  bool gpu = false;
  bool double_precision = false;
  std::string no_double_because;  ///< empty where double_precision
};

/// Every OpenCL device found; empty where there is no platform. Never throws for a missing one.
std::vector<DeviceDescription> list_devices();

class RestorableRun;
class Workshop;

/// The scene's physics on an OpenCL device: "opencl:single", "opencl:mixed", "opencl:double".
class OpenClEngine : public RestartableEngine {
 public:
  /// Throws EngineFailed when there is no such device.
  explicit OpenClEngine(EngineOptions options);
  ~OpenClEngine() override;

  std::string name() const override;
  Support supports(const Scene& scene, const Request& request) const override;
  std::unique_ptr<Run> start(const Scene& scene, const Request& request) override;
  Provenance provenance() const override;
  /// The path that a supported scene is run on; never `automatic`.
  Path path_of(const Scene& scene, const Request& request) const;
  /// For several threads at once: they take turns at the devices, across all engines of a process.
  Observations observe(const Scene& scene, const Request& request) override;

 protected:
  std::unique_ptr<RestartableRun> restored(const Scene& scene, const Request& request, const Checkpoint& from,
                                           std::string& because) override;
  std::unique_ptr<RestartableRun> go_on(const Scene& scene, const Request& request,
                                        const Beginning& beginning) override;

 private:
  bool searches_skin(const Scene& scene) const;
  /// With which a run begins.
  double skin_of(const Scene& scene) const;
  /// On the path that it takes; the scene is supported.
  std::unique_ptr<RestorableRun> begin(const Scene& scene, const Request& request);

  EngineOptions options_;
  std::shared_ptr<Workshop> workshop_;  ///< device, queue and built programs; runs keep it alive
};

}  // namespace grainproof::opencl
