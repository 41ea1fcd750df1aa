// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "model/observations.hpp"
#include "model/scene.hpp"

namespace grainproof::report {

/// Writes walls.csv into a folder as a run goes on: what each wall does to the particles, a line a wall and
/// frame. Force and torque are means since the frame before, from the ledger's impulses; the torque is about
/// the wall's reference point (model/walls.hpp). Throws std::filesystem::filesystem_error.
class WallWriter {
 public:
  WallWriter(const std::filesystem::path& folder, const Scene& scene);

  /// The first frame has no interval before it and is only remembered.
  void write(double time, const Ledger& ledger);

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::vector<std::string> names_;
  double last_time_ = 0.0;
  std::vector<Vec3> last_impulses_;
  std::vector<Vec3> last_moments_;
};

}  // namespace grainproof::report
