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

/// Writes the frames of a run into a folder as they come: frame_NNNNNN.vtp with a frames.pvd for
/// ParaView and, where asked, frames.csv. The .pvd is complete after every frame, so what a run that
/// is stopped leaves behind can be opened. Throws std::filesystem::filesystem_error.
class FrameWriter {
 public:
  FrameWriter(std::filesystem::path folder, const Scene& scene, bool csv);

  void write(const Frame& frame);

  std::size_t written() const { return times_.size(); }

 private:
  std::filesystem::path folder_;
  const Scene& scene_;
  std::ofstream csv_;
  std::vector<double> times_;
};

/// VTK XML PolyData: points, velocity, angular velocity and orientation (w, x, y, z) where there are
/// some, id and diameter.
std::string vtp_text(const Scene& scene, const Frame& frame);

/// ParaView collection: file names relative to itself, with their times.
std::string pvd_text(const std::vector<double>& times);

std::string csv_header(const Scene& scene);

/// A line a particle, in full precision; no header.
std::string csv_text(const Scene& scene, const Frame& frame);

}  // namespace grainproof::report
