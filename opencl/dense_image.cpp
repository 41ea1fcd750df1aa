// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_image.hpp"

#include <algorithm>
#include <cmath>

#include "model/strides.hpp"
#include "opencl/bytes.hpp"
#include "opencl/flow_terms.hpp"
#include "opencl/near_walls.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

/// Where a centre is within its cell: unsigned, over the whole range of its type.
struct Place {
  cl_int cell;
  std::uint64_t phase;
  double part;  ///< of a unit, what the phase leaves out
};

Place place_of(double from_lower, double cell, int bits) {
  const long double cells = static_cast<long double>(from_lower) / cell;
  const long double whole = std::floor(cells);
  const long double units = std::ldexp(cells - whole, bits);
  const long double phase = std::floor(units);
  return {static_cast<cl_int>(whole), static_cast<std::uint64_t>(phase), static_cast<double>(units - phase)};
}

cl_double4 four(const Vec3& v, double w = 0.0) {
  return {{v[0], v[1], v[2], w}};
}

template <class P>
class DenseImager {
 public:
  using Real = typename P::Real;
  static constexpr bool twice = sizeof(Real) == 8;
  static constexpr int bits = twice ? 64 : 32;
  using Phase = std::conditional_t<twice, cl_long, cl_int>;

  DenseImager(const Scene& scene, const DenseOptions& options, const DenseGrid& grid)
      : scene_(scene), options_(options), grid_(grid) {}

  DenseImage make(std::size_t granularity) {
    DenseImage image;
    image.particles = scene_.particles.size();
    image.padded = (image.particles + granularity - 1) / granularity * granularity;
    image.box = box_bytes();
    image.planes = planes();
    image.laws = laws();
    add_particles(image);
    return image;
  }

  Bytes box_bytes() const { return bytes_of(std::vector{box()}); }

 private:
  double radius_unit() const { return std::ldexp(grid_.largest_radius, 3 - bits); }
  Vec3 quantum() const { return grid_.cell * std::ldexp(1.0, -bits); }

  DenseBox<P> box() const {
    const Particle& p = scene_.particles.front();
    const double mass = mass_of(p, scene_), radius = p.diameter / 2, step = scene_.run.step;
    const double skin = grid_.skin;
    DenseBox<P> b{};
    b.quantum = four(quantum(), radius_unit());
    b.lower = four(grid_.lower);
    b.cell = four(grid_.cell);
    b.alike = {{2 * radius, radius, 0.51 * skin, 0.51 * skin}};
    b.metre = four_of<P>(quantum(), radius_unit());
    b.drift = four_of<P>(quantum().cwiseInverse() * step);
    b.gravity = four_of<P>(std::get<ConstantGravity>(scene_.gravity).acceleration);
    b.time = four_of<P>({step, step / 2, most_speed() * most_speed()}, may_leap(scene_) ? step * step : 0.0);
    b.limits = four_of<P>({scene_.run.overlap_limit, 0.25 * skin * skin, 1.0 + 1e-5}, fastest_square());
    b.body = four_of<P>({radius, 1.0 / mass, 1.0 / inertia_of(p, scene_)}, std::sqrt(mass / 2));
    b.body_units = four_of<P>({sum_unit(), sum_unit() * grid_.largest_radius, 0.0});
    set_search(b, 2 * radius);
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      b.coarse.s[axis] = std::ldexp(1.0, 32) / grid_.cells[k];
      b.cells.s[axis] = grid_.cells[k];
      b.zones.s[axis] = grid_.zone_counts[k];
      b.periodic.s[axis] = grid_.periodic[k];
      // Nothing leaves through a periodic face, though a place may lie beyond it until the next list.
      b.domain_lower.s[axis] = grid_.periodic[k] ? -HUGE_VAL : scene_.domain.lower[axis];
      b.domain_upper.s[axis] = grid_.periodic[k] ? HUGE_VAL : scene_.domain.upper[axis];
    }
    // Three layers of such a band, of some hundred bytes a particle, are to stay in a core's cache.
    b.periodic.s[3] = std::min(8, grid_.zone_counts[1]);
    if (options_.corrected) b.zones.s[3] = flow_terms(scene_, twice ? 0x1p-58 : 0x1p-29);
    b.counts = {{static_cast<cl_int>(scene_.particles.size()),
                 static_cast<cl_int>(near_walls(scene_).planes.size()),
                 static_cast<cl_int>(scene_.materials.size()), p.material}};
    return b;
  }

  /// That a run survives: of the largest body, where one that moves by more than its radius in a step has
  /// leapt. Two that go on for an eighth of a cell after a list's last step are still told apart.
  double most_speed() const {
    const double stride = 0.125 * grid_.cell.minCoeff();
    return (may_leap(scene_) ? std::min(stride, grid_.largest_radius) : stride) / scene_.run.step;
  }

  /// Of force, a power of two, so that no sum over 2^8 contacts of the deepest overlap and the highest speed
  /// that a run survives reaches 2^62. The tangential force is at most the normal one's, times a coefficient
  /// taken as 4.
  double sum_unit() const {
    const auto material = static_cast<std::size_t>(scene_.particles.front().material);
    double strongest = 0.0, heaviest = 0.0;
    for (const Particle& p : scene_.particles) heaviest = std::max(heaviest, mass_of(p, scene_));
    for (std::size_t other = 0; other < scene_.materials.size(); ++other) {
      if (!scene_.contacts.has(material, other)) continue;
      const PairCoefficients c = coefficients_of(scene_, material, other);
      const double elastic = std::max(c.stiffness, c.history.stiffness) * 2.0 * grid_.largest_radius;
      const double damping = c.damping.at(heaviest) + c.history.damping.at(heaviest);
      strongest = std::max(strongest, elastic + damping * 2.0 * most_speed());
    }
    return std::exp2(std::ceil(std::log2(strongest)) + 10.0 - 62.0);
  }

  /// All have rows for springs from the start then: kernels/dense_springs.cl.
  bool all_are_near() const { return grid_.skin <= 0.04 * grid_.largest_radius; }
  /// By how much two bodies may come closer in a step.
  double approach() const { return 0.25 * grid_.skin; }
  double fastest_square() const {
    // What corrections move bodies by comes on top.
    const double share = options_.corrected ? 0.3 : 0.45;
    const double fastest = share * approach() / scene_.run.step;
    return all_are_near() ? HUGE_VAL : fastest * fastest;
  }

  /// How far a list looks, with room for the rounding of coarse places.
  void set_search(DenseBox<P>& b, double diameter) const {
    const double unit = std::ldexp(grid_.extent.maxCoeff(), -32);
    const double margin = 8.0 * unit + 1e-6 * (2 * grid_.largest_radius + grid_.skin);
    const double reach = grid_.skin + margin;
    // Springs are carried over for near partners alone: whoever touches is one, at any skin.
    // A contact that has just ended is still corrected with its spring.
    const double parted = options_.corrected ? 0.3 * grid_.skin : 0.0;
    const double near = (all_are_near() ? grid_.skin : std::max(0.02 * diameter, parted)) + margin;
    for (int axis = 0; axis < 3; ++axis)
      b.coarse_metre.s[axis] = static_cast<cl_float>(std::ldexp(grid_.extent[axis], -32));
    b.coarse_metre.s[3] = static_cast<cl_float>(reach);
    b.near = {{static_cast<cl_float>(near), static_cast<cl_float>(diameter + reach),
               static_cast<cl_float>(diameter + near), static_cast<cl_float>(approach())}};
  }

  Bytes planes() const {
    std::vector<DensePlane> planes;
    for (const auto& wall : near_walls(scene_).planes)
      planes.push_back({four(wall.shape.normal, wall.shape.normal.dot(wall.shape.point)),
                        {{wall.material, wall.index, 0, 0}}});
    return bytes_of(planes);
  }

  /// The zoned path's own table, of a scene without its particles.
  Bytes laws() const {
    Scene bare;
    bare.run = scene_.run;
    bare.domain = scene_.domain;
    bare.materials = scene_.materials;
    bare.contacts = scene_.contacts;
    bare.gravity = scene_.gravity;
    return make_image(bare, options_.precision, {}, 1).laws;
  }

  void add_particles(DenseImage& image) const {
    const auto quarters = static_cast<std::size_t>(quarters_of(options_));
    const auto group = static_cast<std::size_t>(group_size(options_));
    const auto numbers = static_cast<std::size_t>(kept_numbers(options_.precision));
    std::vector<typename P::Real4> records(image.padded * quarters, four_of<P>(Vec3::Zero()));
    std::vector<Real> kept(image.padded * numbers);
    std::vector<Phase> built_at(image.padded * 3);
    std::vector<cl_int> cells(image.padded);
    for (std::size_t i = 0; i < image.particles; ++i) {
      const Particle& p = scene_.particles[i];
      std::array<Phase, 4> phases{};
      for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        Place place = place_of(p.position[axis] - grid_.lower[axis], grid_.cell[axis], bits);
        if (grid_.periodic[k]) place.cell = (place.cell + grid_.cells[k]) % grid_.cells[k];
        phases[k] = static_cast<Phase>(place.phase);
        built_at[i / group * 3 * group + k * group + i % group] = phases[k];
        if (numbers > 0)
          kept[i / group * numbers * group + k * group + i % group] = static_cast<Real>(place.part);
        cells[i] |= place.cell << (10 * axis);
      }
      phases[3] = static_cast<Phase>(std::nearbyint(p.diameter / 2 / radius_unit()));
      std::memcpy(&records[i * quarters], phases.data(), sizeof(phases));
      records[i * quarters + 1] = four_of<P>(p.velocity, p.fixed ? 0.0 : 1.0 / mass_of(p, scene_));
      if (options_.rotation) records[i * quarters + 2] = four_of<P>(p.angular_velocity);
      if (options_.predicted) {
        const std::size_t middle = i * quarters + static_cast<std::size_t>(middle_quarter(options_));
        records[middle] = four_of<P>(p.velocity);
        if (options_.rotation && options_.varied) records[middle + 1] = four_of<P>(p.angular_velocity);
        if (options_.rotation && !options_.varied)
          for (std::size_t k = 0; k < 3; ++k)
            records[i * quarters + 1 + k].s[3] =
                static_cast<Real>(p.angular_velocity[static_cast<Eigen::Index>(k)]);
      }
    }
    image.records = bytes_of(records);
    image.kept = bytes_of(kept);
    image.built_at = bytes_of(built_at);
    image.cells = bytes_of(cells);
  }

  const Scene& scene_;
  const DenseOptions& options_;
  const DenseGrid& grid_;
};

template <class P>
DenseBody decoded_as(const DenseRecords& read, std::size_t i, const DenseOptions& options,
                     const DenseGrid& grid) {
  using Phase = typename DenseImager<P>::Phase;
  using Bare = std::make_unsigned_t<Phase>;
  const auto quarters = static_cast<std::size_t>(quarters_of(options));
  const auto group = static_cast<std::size_t>(group_size(options));
  const auto numbers = static_cast<std::size_t>(kept_numbers(options.precision));
  const auto vector = [&](std::size_t quarter) {
    const auto v = value_at<typename P::Real4>(read.records, i * quarters + quarter);
    return Vec3(v.s[0], v.s[1], v.s[2]);
  };
  DenseBody body{Vec3::Zero(), vector(1), options.rotation ? vector(2) : Vec3::Zero()};
  const cl_int cells = value_at<cl_int>(read.cells, i);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const auto now = value_at<Phase>(read.records, i * quarters * 4 + k);
    const auto then = value_at<Phase>(read.built_at, i / group * 3 * group + k * group + i % group);
    const auto moved = static_cast<Phase>(static_cast<Bare>(now) - static_cast<Bare>(then));
    const double part = numbers > 0 ? value_at<typename P::Real>(
                                          read.kept, i / group * numbers * group + k * group + i % group)
                                    : 0.0;
    cl_int cell = cells >> (10 * k) & 1023;
    if (moved >= 0 && static_cast<Bare>(now) < static_cast<Bare>(then)) ++cell;
    if (moved < 0 && static_cast<Bare>(now) > static_cast<Bare>(then)) --cell;
    if (grid.periodic[k]) cell = (cell + grid.cells[k]) % grid.cells[k];
    // Of the cell it is in now, so that rounding does not tell where it was when the list was made.
    const long double units = static_cast<long double>(static_cast<Bare>(now)) + part;
    long double at = cell + std::ldexp(units, -DenseImager<P>::bits);
    if (grid.periodic[k] && at < 0) at += grid.cells[k];
    if (grid.periodic[k] && at >= grid.cells[k]) at -= grid.cells[k];
    const double x = static_cast<double>(grid.lower[axis] + at * grid.cell[axis]);
    const bool rounded_out = grid.periodic[k] && x >= grid.lower[axis] + grid.extent[axis];
    body.position[axis] = rounded_out ? grid.lower[axis] : x;
  }
  return body;
}

}  // namespace

DenseGrid::DenseGrid(const Scene& scene, double list_skin) : skin(list_skin), largest_radius(0.0) {
  for (const Particle& p : scene.particles) largest_radius = std::max(largest_radius, p.diameter / 2);
  // Cells, and so the bits of positions, are the same for every usual skin.
  const double reach = 2.0 * (largest_radius + std::max(skin, 0.6 * largest_radius));
  const double width = (2.0 * largest_radius + skin) * (1.0 + 1e-5);
  const double most = 4.0 * static_cast<double>(scene.particles.size()) + 64.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    periodic[k] = scene.domain.periodic(axis);
    const double margin = periodic[k] ? 0.0 : 1.25 * reach;
    lower[axis] = scene.domain.lower[axis] - margin;
    extent[axis] = scene.domain.extent()[axis] + 2.0 * margin;
    cells[k] = static_cast<int>(std::clamp(std::floor(extent[axis] / (2.5 * reach)), 1.0, 1023.0));
    cell[axis] = extent[axis] / cells[k];
  }
  double coarsening = 1.0;
  do {
    for (int axis = 0; axis < 3; ++axis)
      zone_counts[static_cast<std::size_t>(axis)] =
          static_cast<int>(std::clamp(std::floor(extent[axis] / (width * coarsening)), 1.0, 2048.0));
    coarsening *= 1.25;
  } while (static_cast<double>(zone_counts[0]) * zone_counts[1] * zone_counts[2] > most);
}

DenseImage make_dense_image(const Scene& scene, const DenseOptions& options, const DenseGrid& grid,
                            std::size_t granularity) {
  return with_types_of(options.precision, [&](auto types) {
    return DenseImager<decltype(types)>(scene, options, grid).make(granularity);
  });
}

Bytes make_dense_box(const Scene& scene, const DenseOptions& options, const DenseGrid& grid) {
  return with_types_of(options.precision, [&](auto types) {
    return DenseImager<decltype(types)>(scene, options, grid).box_bytes();
  });
}

DenseBody decoded(const DenseRecords& read, std::size_t i, const DenseOptions& options,
                  const DenseGrid& grid) {
  return with_types_of(options.precision,
                       [&](auto types) { return decoded_as<decltype(types)>(read, i, options, grid); });
}

}  // namespace grainproof::opencl
