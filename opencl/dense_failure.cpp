// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "model/strides.hpp"
#include "opencl/bytes.hpp"
#include "opencl/dense_run.hpp"
#include "opencl/failure.hpp"
#include "opencl/layout.hpp"
#include "opencl/near_walls.hpp"

namespace grainproof::opencl {
namespace {

/// Of what the device compares.
constexpr double hair = 1e-6;

constexpr cl_int4 no_fault{{never, 0, 0, 0}};

/// `rounding`: the device decides without what is below a unit of position.
cl_int face_left(const Vec3& x, const Domain& domain, const Vec3& rounding) {
  for (int axis = 0; axis < 3; ++axis) {
    if (domain.periodic(axis)) continue;
    if (x[axis] < domain.lower[axis] + rounding[axis]) return 2 * axis;
    if (x[axis] > domain.upper[axis] - rounding[axis]) return 2 * axis + 1;
  }
  return -1;
}

double distance(Vec3 d, const Domain& domain) {
  for (int axis = 0; axis < 3; ++axis)
    if (domain.periodic(axis)) d[axis] -= domain.extent()[axis] * std::round(d[axis] / domain.extent()[axis]);
  return d.norm();
}

/// The partner, or −1 − wall, that a body overlaps most, and by what fraction of the smaller radius.
struct Deepest {
  double fraction = 0.0;
  cl_int partner = 0;
};

/// Who leapt, left the domain or has no place; `cell` is the zones' edges in m.
std::vector<cl_int4> escapes(const Scene& scene, const std::vector<DenseBody>& all, const Vec3& cell,
                             cl_int step) {
  std::vector<cl_int4> faults(all.size(), no_fault);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double moved = all[i].velocity.norm() * scene.run.step;
    const cl_int face = face_left(all[i].position, scene.domain, cell * 0x1p-31);
    if (may_leap(scene) && moved > 0.5 * scene.particles[i].diameter * (1.0 - hair))
      faults[i] = {{step, leapt, 0, 0}};
    else if (!(moved < 0.125 * cell.minCoeff() * (1.0 - hair)))
      faults[i] = {{step, not_a_number, 0, 0}};
    else if (face >= 0)
      faults[i] = {{step, left_domain, face, 0}};
  }
  return faults;
}

/// Of every body, from the list of `group` bodies a head.
std::vector<Deepest> deepest_overlaps(const Scene& scene, const std::vector<DenseBody>& all,
                                      const DenseLists& lists, std::size_t group) {
  const NearWalls near = near_walls(scene);
  std::vector<Deepest> deepest(all.size());
  const auto note = [&](std::size_t i, double overlap, double radius, cl_int partner) {
    if (overlap / radius > deepest[i].fraction) deepest[i] = {overlap / radius, partner};
  };
  for (std::size_t at = 0; at < all.size(); ++at) {
    const cl_int4& head = lists.heads[at / group];
    const auto i = static_cast<std::size_t>(lists.ids[at]);
    const double radius = scene.particles[i].diameter / 2;
    for (const auto& wall : near.planes)
      note(i, radius - (all[i].position - wall.shape.point).dot(wall.shape.normal), radius, -1 - wall.index);
    for (cl_int k = head.s[3]; k < head.s[1]; ++k) {
      const auto slot = static_cast<std::size_t>(head.s[0] + k);
      const auto j = static_cast<std::size_t>(
          lists.ids[static_cast<std::size_t>(lists.entries[slot * group + at % group])]);
      if (i == j) continue;
      const double other = scene.particles[j].diameter / 2;
      const double gap = distance(all[j].position - all[i].position, scene.domain);
      note(i, radius + other - gap, std::min(radius, other), static_cast<cl_int>(j));
    }
  }
  return deepest;
}

/// Who is deeper than allowed. The device has rounded: the deepest of all counts even where it is a hair's
/// breadth below the limit.
std::vector<cl_int4> too_deep_ones(const std::vector<Deepest>& deepest, double allowed, cl_int step) {
  std::vector<cl_int4> faults(deepest.size(), no_fault);
  double most = 0.0;
  for (const Deepest& d : deepest) most = std::max(most, d.fraction);
  const double limit = std::min(allowed, most * (1.0 - hair));
  for (std::size_t i = 0; i < deepest.size(); ++i)
    if (deepest[i].fraction > limit) faults[i] = {{step, too_deep, deepest[i].partner, 0}};
  return faults;
}

}  // namespace

// The device says only when and of which kind; who it was is looked up in what it holds of that boundary.
void DenseRun::tell_what_went_wrong(cl_int step, bool escaped) {
  settled_ = true;
  const auto all = bodies(world_.records[static_cast<std::size_t>(step & 1)]);
  const auto faults = escaped ? escapes(scene_, all, grid_.cell, step)
                              : too_deep_ones(deepest_overlaps(scene_, all, read_lists(), group()),
                                              scene_.run.overlap_limit, step);
  throw_failure(scene_, step, bytes_of(faults), first_step_);
}

}  // namespace grainproof::opencl
