// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "model/engine.hpp"

namespace grainproof {

/// LIGGGHTS as an engine: writes a deck for a scene, runs the program in a private folder, reads the
/// dump. Many scenes go into one process. Its integrator is velocity Verlet with the half-step velocity
/// in the dashpot, which is leap-frog's trajectory too.
class LiggghtsEngine : public Engine {
 public:
  struct Options {
    std::string program = "liggghts";
    int processes = 1;  ///< above 1 through mpirun, for scenes of 1000 particles or more
  };

  LiggghtsEngine();
  explicit LiggghtsEngine(Options options);

  std::string name() const override { return "liggghts"; }
  Support supports(const Scene& scene, const Request& request) const override;
  /// Throws EngineFailed with what LIGGGHTS said last.
  Observations observe(const Scene& scene, const Request& request) override;
  std::vector<Observations> observe_all(std::span<const Scene> scenes, const Request& request) override;

 private:
  std::vector<Observations> observe_batch(std::span<const Scene> scenes, const Request& request) const;
  std::vector<std::string> command(std::span<const Scene> scenes) const;

  Options options_;
  bool installed_;
};

}  // namespace grainproof
