// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::reference {

/// A wall as it stands and moves at one moment.
struct WallNow {
  WallShape shape;
  std::int32_t material;
  Vec3 reference;  ///< model/walls.hpp
  bool moving = false;
  Vec3 velocity = Vec3::Zero();  ///< of the reference point, m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s

  /// Of the surface at one of its points, m/s.
  Vec3 velocity_at(const Vec3& point) const { return velocity + spin.cross(point - reference); }
};

/// The walls of a scene in their prescribed motion (docs/laws/walls.md).
class Walls {
 public:
  /// Keeps a reference to the walls of the scene.
  explicit Walls(const Scene& scene);

  void move_to(double time);

  std::size_t size() const { return now_.size(); }
  const WallNow& operator[](std::size_t wall) const { return now_[wall]; }
  std::vector<WallNow>::const_iterator begin() const { return now_.begin(); }
  std::vector<WallNow>::const_iterator end() const { return now_.end(); }

 private:
  std::span<const Wall> drawn_;
  std::vector<WallNow> now_;
};

}  // namespace grainproof::reference
