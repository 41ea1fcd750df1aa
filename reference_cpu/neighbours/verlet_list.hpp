// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "model/sections.hpp"
#include "reference_cpu/bodies.hpp"
#include "reference_cpu/periodic_box.hpp"

namespace grainproof::reference {

/// Sweetman chapter 2: a list made with a skin holds until two particles can have come closer by all
/// of it, that is until twice the largest displacement since the list was made exceeds the skin.
class VerletList {
 public:
  explicit VerletList(double skin) : skin_(skin) {}

  double skin() const { return skin_; }
  bool outdated(const Bodies& bodies, const PeriodicBox& box) const;
  void made(const Bodies& bodies);

  void pack_into(Sections& own) const { pack(own, "verlet.position_when_made", position_when_made_); }
  void unpack_from(const Sections& own) { unpack(own, "verlet.position_when_made", position_when_made_); }

 private:
  double skin_;
  std::vector<Vec3> position_when_made_;
};

}  // namespace grainproof::reference
