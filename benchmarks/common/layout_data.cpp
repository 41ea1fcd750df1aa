// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/layout_data.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "benchmarks/common/scenes.hpp"
#include "reference_cpu/neighbours/chain_cells.hpp"

namespace grainproof::bench {
namespace {

constexpr float reach = 1.1F;  // diameters: contact and a usual skin
constexpr std::size_t group = 64;

struct Zones {
  cl_int4 count{};
  float inverse_width = 1.0F;

  int of(const cl_float4& p) const {
    const auto along = [&](int axis) {
      return std::min(static_cast<int>(p.s[axis] * inverse_width), count.s[axis] - 1);
    };
    return (along(2) * count.s[1] + along(1)) * count.s[0] + along(0);
  }
};

Zones zones_over(const std::vector<cl_float4>& positions, float width) {
  Zones zones;
  zones.inverse_width = 1.0F / width;
  for (const cl_float4& p : positions)
    for (int axis = 0; axis < 3; ++axis)
      zones.count.s[axis] = std::max(zones.count.s[axis], static_cast<int>(p.s[axis] / width) + 1);
  return zones;
}

std::vector<cl_float4> sorted(const std::vector<cl_float4>& positions, const Zones& zones) {
  std::vector<cl_float4> out = positions;
  std::stable_sort(out.begin(), out.end(),
                   [&](const cl_float4& a, const cl_float4& b) { return zones.of(a) < zones.of(b); });
  return out;
}

std::vector<cl_int2> close_pairs(const std::vector<cl_float4>& positions) {
  Scene scene = empty_scene(Vec3::Ones());
  scene.domain.boundary = {Boundary::open, Boundary::open, Boundary::open};
  for (const cl_float4& p : positions)
    scene.particles.push_back({.id = static_cast<std::int64_t>(scene.particles.size()) + 1,
                               .material = 0,
                               .diameter = 1.0,
                               .effect_diameter = 1.0,
                               .position = Vec3(p.s[0], p.s[1], p.s[2]),
                               .velocity = Vec3::Zero()});
  const reference::Bodies bodies = reference::bodies_of(scene);
  const reference::PeriodicBox box(scene.domain);
  reference::ChainCells cells;
  reference::PairList list;
  cells.fill(reference::grid_over(bodies, box, reach), bodies);
  cells.list_pairs(bodies, box, reach - 1.0, list);
  std::vector<cl_int2> pairs;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::int32_t k = list.first(i); k < list.last(i); ++k)
      pairs.push_back({{static_cast<cl_int>(i), list.partner(k)}});
  return pairs;
}

void list_partners(LayoutData& data) {
  data.starts.assign(data.positions.size() + 1, 0);
  for (const cl_int2& pair : data.pairs)
    for (cl_int body : pair.s) ++data.starts[static_cast<std::size_t>(body) + 1];
  std::partial_sum(data.starts.begin(), data.starts.end(), data.starts.begin());
  std::vector<cl_int> next = data.starts;
  data.partners.resize(2 * data.pairs.size());
  data.entries.resize(2 * data.pairs.size());
  for (std::size_t k = 0; k < data.pairs.size(); ++k)
    for (int end = 0; end < 2; ++end) {
      const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(data.pairs[k].s[end])]++);
      data.partners[at] = data.pairs[k].s[1 - end];
      data.entries[at] = end == 0 ? static_cast<cl_int>(k) : -1 - static_cast<cl_int>(k);
    }
}

}  // namespace

LayoutData layout_data(std::int64_t particles, const std::filesystem::path& cache) {
  LayoutData data;
  for (const Particle& p : bed(particles, cache).particles) {
    const Vec3 at = p.position / diameter;
    data.positions.push_back(
        {{static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z()), 0}});
  }
  data.positions.resize(data.positions.size() / group * group);
  data.positions = sorted(data.positions, zones_over(data.positions, reach));
  data.pairs = close_pairs(data.positions);
  list_partners(data);
  return data;
}

ZonedData sort_by_zones(const LayoutData& data, double share) {
  const Zones zones = zones_over(data.positions, reach * static_cast<float>(share));
  ZonedData out;
  out.positions = sorted(data.positions, zones);
  const int total = zones.count.s[0] * zones.count.s[1] * zones.count.s[2];
  out.zone_starts.assign(static_cast<std::size_t>(total) + 1, 0);
  for (const cl_float4& p : out.positions) ++out.zone_starts[static_cast<std::size_t>(zones.of(p)) + 1];
  std::partial_sum(out.zone_starts.begin(), out.zone_starts.end(), out.zone_starts.begin());
  out.zones = zones.count;
  out.zones.s[3] = 1;
  const float inverse = zones.inverse_width;
  out.inverse_width = {{inverse, inverse, inverse, 0.0F}};
  out.around = static_cast<cl_int>(std::ceil(1.0 / share - 1e-6));
  out.reach2 = reach * reach;
  return out;
}

}  // namespace grainproof::bench
