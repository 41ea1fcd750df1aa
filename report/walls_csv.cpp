// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/walls_csv.hpp"

#include "report/files.hpp"
#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

std::string columns(const Vec3& value) {
  return "," + exact(value.x()) + "," + exact(value.y()) + "," + exact(value.z());
}

}  // namespace

WallWriter::WallWriter(const std::filesystem::path& folder, const Scene& scene)
    : file_(folder / "walls.csv"), out_(file_) {
  for (const Wall& wall : scene.walls) names_.push_back(wall.name);
  require_written(out_ << "time,wall,fx,fy,fz,tx,ty,tz\n", file_);
}

void WallWriter::write(double time, const Ledger& ledger) {
  if (ledger.wall_impulses.size() != names_.size()) return;  // an engine that keeps none of walls
  const double interval = time - last_time_;
  if (!last_impulses_.empty() && interval > 0.0)
    for (std::size_t w = 0; w < names_.size(); ++w)
      out_ << exact(time) << ',' << names_[w]
           << columns((ledger.wall_impulses[w] - last_impulses_[w]) / interval)
           << columns((ledger.wall_angular_impulses[w] - last_moments_[w]) / interval) << '\n';
  require_written(out_ << std::flush, file_);
  last_time_ = time;
  last_impulses_ = ledger.wall_impulses;
  last_moments_ = ledger.wall_angular_impulses;
}

}  // namespace grainproof::report
