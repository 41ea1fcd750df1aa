// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/scene_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/strides.hpp"
#include "opencl/bytes.hpp"
#include "opencl/coordinates.hpp"
#include "opencl/pair_laws.hpp"
#include "opencl/wall_image.hpp"

namespace grainproof::opencl {
namespace {

double viscosity_of(const Flow& flow) {
  return std::visit(
      Overloaded{[](const NoFlow&) { return 0.0; }, [](const auto& fluid) { return fluid.viscosity; }}, flow);
}

template <class P>
class Imager {
 public:
  Imager(const Scene& scene, const ZoneGrid& grid, std::size_t work_group)
      : scene_(scene), grid_(grid), coordinates_(scene.domain) {
    image_.near = near_walls(scene);
    image_.particles = scene.particles.size();
    image_.padded = (std::max<std::size_t>(image_.particles, 1) + work_group - 1) / work_group * work_group;
  }

  SceneImage make() {
    image_.box = bytes_of(std::vector{coordinates_.box(scene_.domain, grid_.zones, grid_.skin)});
    image_.constants = bytes_of(std::vector{constants()});
    image_.laws = bytes_of(laws());
    add_walls();
    add_particles();
    return std::move(image_);
  }

 private:
  using Real = typename P::Real;

  Constants<P> constants() const {
    const double step = scene_.run.step, drift = step * coordinates_.per_metre();
    Constants<P> c{};
    c.time = {{static_cast<Real>(step), static_cast<Real>(step / 2), static_cast<Real>(drift),
               static_cast<Real>(drift / 2)}};
    c.limits.s[0] = static_cast<Real>(scene_.run.overlap_limit);
    c.limits.s[1] = may_leap(scene_) ? Real{1} : Real{0};
    c.limits.s[2] = static_cast<Real>(step - static_cast<double>(static_cast<Real>(step)));
    c.counts = {{static_cast<cl_int>(image_.particles), static_cast<cl_int>(scene_.materials.size()),
                 static_cast<cl_int>(image_.near.planes.size()),
                 static_cast<cl_int>(image_.near.rectangles.size())}};
    c.walls = {{static_cast<cl_int>(image_.near.count()), static_cast<cl_int>(image_.near.cylinders.size()),
                static_cast<cl_int>(image_.near.moving()), 0}};
    std::visit(Overloaded{[&](const ConstantGravity& g) { c.gravity = four_of<P>(g.acceleration); },
                          [](const RotatingGravity&) {},
                          [&](const CentralGravity& g) {
                            c.gravity = four_of<P>(Vec3::Zero(), g.magnitude);
                            c.gravity_centre = coordinates_.position(g.centre);
                          }},
               scene_.gravity);
    std::visit(Overloaded{[](const NoFlow&) {},
                          [&](const UniformFlow& flow) { c.stream = four_of<P>(flow.velocity); },
                          [&](const TaylorGreenFlow& flow) {
                            c.stream = four_of<P>(Vec3::Zero(), flow.amplitude);
                            c.wave = coordinates_.wave(flow.wave_number);
                          }},
               scene_.flow);
    return c;
  }

  static PairLaw<P> rounded(const PairCoefficients& c) {
    constexpr Real largest = std::numeric_limits<Real>::max();
    PairLaw<P> law{};
    law.stiffness = static_cast<Real>(c.stiffness);
    law.damping = static_cast<Real>(c.damping.constant);
    law.damping_root_mass = static_cast<Real>(c.damping.per_root_mass);
    law.lowest = c.no_tension ? Real(0) : -largest;
    law.friction = static_cast<Real>(c.friction);
    law.viscosity = c.unlimited ? largest : static_cast<Real>(c.viscosity.constant);
    law.viscosity_root_mass = static_cast<Real>(c.viscosity.per_root_mass);
    law.cohesion = static_cast<Real>(c.cohesion);
    law.rolling = static_cast<Real>(c.rolling);
    law.rolls = static_cast<cl_int>(c.rolls);
    law.hertz = c.hertz;
    remember(law, c.history);
    return law;
  }

  static void remember(PairLaw<P>& law, const HistoryCoefficients& h) {
    if (!h.present) return;
    law.sliding = static_cast<Real>(h.coefficient);
    law.spring = static_cast<Real>(h.stiffness);
    law.spring_damping = static_cast<Real>(h.damping.constant);
    law.spring_damping_root_mass = static_cast<Real>(h.damping.per_root_mass);
    law.history = remembers | (h.limit == CoulombLimit::spring ? limit_on_spring : 0) |
                  (h.arm == TorqueArm::overlap ? arm_shortened : 0) |
                  (h.turn == SpringTurn::project ? turn_projects : 0) |
                  (law.hertz != 0 && h.memory == SpringMemory::force ? keeps_force : 0);
  }

  std::vector<PairLaw<P>> laws() const {
    const std::size_t materials = scene_.materials.size();
    std::vector<PairLaw<P>> table(materials * materials);
    for (std::size_t a = 0; a < materials; ++a)
      for (std::size_t b = 0; b < materials; ++b)
        if (scene_.contacts.has(a, b)) table[a * materials + b] = rounded(coefficients_of(scene_, a, b));
    return table;
  }

  void add_walls() {
    WallBytes walls = wall_bytes(image_.near, scene_, P::precision);
    image_.planes = std::move(walls.planes);
    image_.rectangles = std::move(walls.rectangles);
    image_.cylinders = std::move(walls.cylinders);
  }

  /// Padding counts as fixed and is never listed, so kernels need no test for it.
  void add_particles() {
    const double viscosity = viscosity_of(scene_.flow);
    std::vector<typename P::Position> positions(image_.padded, coordinates_.position(scene_.domain.lower));
    std::vector<typename P::Real4> velocities(image_.padded, four_of<P>(Vec3::Zero()));
    std::vector<cl_int> materials(image_.padded);
    std::vector<typename P::Reach> reaches(image_.padded, coordinates_.reach(0.0));
    std::vector<Real> drag_rates(image_.padded);
    for (std::size_t i = 0; i < image_.particles; ++i) {
      const Particle& p = scene_.particles[i];
      const double mass = mass_of(p, scene_);
      positions[i] = coordinates_.position(p.position, p.diameter / 2);
      velocities[i] = four_of<P>(p.velocity, p.fixed ? 0.0 : 1.0 / mass);
      materials[i] = p.material;
      reaches[i] = coordinates_.reach(std::max(p.effect_diameter, p.diameter) / 2);
      drag_rates[i] = static_cast<Real>(3.0 * M_PI * viscosity * p.diameter / mass);
    }
    add_spins();
    image_.positions = bytes_of(positions);
    image_.velocities = bytes_of(velocities);
    image_.materials = bytes_of(materials);
    image_.reaches = bytes_of(reaches);
    image_.drag_rates = bytes_of(drag_rates);
  }

  /// Zeros, inverse inertia included, where nothing turns.
  void add_spins() {
    std::vector<typename P::Real4> spins(scene_.rotation ? image_.padded : 0, four_of<P>(Vec3::Zero()));
    for (std::size_t i = 0; i < image_.particles && scene_.rotation; ++i) {
      const Particle& p = scene_.particles[i];
      spins[i] = four_of<P>(p.angular_velocity, p.fixed ? 0.0 : 1.0 / inertia_of(p, scene_));
    }
    image_.spins = bytes_of(spins);
    image_.as_drawn = bytes_of(std::vector{four_of<P>(Vec3::Zero(), 1.0)});
  }

  const Scene& scene_;
  const ZoneGrid& grid_;
  Coordinates<P> coordinates_;
  SceneImage image_;
};

template <class P>
std::array<int, 13> sizes_of() {
  return {sizeof(typename P::Position), sizeof(typename P::Reach), sizeof(typename P::Box),
          sizeof(Constants<P>),         sizeof(PairLaw<P>),        sizeof(PlaneOf<P>),
          sizeof(RectangleOf<P>),       sizeof(Tally<P>),          sizeof(LedgerSums<P>),
          sizeof(CylinderOf<P>),        sizeof(Stand<P>),          sizeof(WallTally<P>),
          sizeof(WallSums<P>)};
}

template <class P>
Bytes table_of(const RotatingGravity& g, double step, std::int64_t first, std::int64_t last) {
  std::vector<typename P::Real4> table;
  table.reserve(static_cast<std::size_t>(last - first + 1));
  for (std::int64_t n = first; n <= last; ++n) {
    const double t = static_cast<double>(n) * step / g.time_scale;
    table.push_back(four_of<P>(g.magnitude * Vec3(std::sin(t * t), -std::cos(t * t), 0.0)));
  }
  return bytes_of(table);
}

}  // namespace

ZoneGrid choose_zones(const Scene& scene, double skin) {
  ZoneGrid grid;
  grid.skin = skin;
  // The margin covers the rounding of positions where a zone is looked up.
  const double width = (2.0 * largest_reach(scene) + skin) * (1.0 + 1e-6);
  const double most = 2.0 * static_cast<double>(scene.particles.size()) + 64.0;
  const Vec3 extent = scene.domain.extent();
  double coarsening = 1.0;
  do {
    for (int axis = 0; axis < 3; ++axis)
      grid.zones[static_cast<std::size_t>(axis)] =
          static_cast<int>(std::clamp(std::floor(extent[axis] / (width * coarsening)), 1.0, 1024.0));
    coarsening *= 1.25;
  } while (static_cast<double>(grid.zones[0]) * grid.zones[1] * grid.zones[2] > most);
  return grid;
}

SceneImage make_image(const Scene& scene, Precision precision, const ZoneGrid& grid, std::size_t work_group) {
  return with_types_of(precision,
                       [&](auto types) { return Imager<decltype(types)>(scene, grid, work_group).make(); });
}

Bytes gravity_table(const Gravity& gravity, double step, std::int64_t first, std::int64_t last,
                    Precision precision) {
  const auto* rotating = std::get_if<RotatingGravity>(&gravity);
  const RotatingGravity none{0.0, 1.0};
  if (rotating == nullptr) last = first;
  const RotatingGravity& g = rotating != nullptr ? *rotating : none;
  return with_types_of(precision,
                       [&](auto types) { return table_of<decltype(types)>(g, step, first, last); });
}

std::array<int, 13> shared_sizes(Precision precision) {
  return with_types_of(precision, [](auto types) { return sizes_of<decltype(types)>(); });
}

}  // namespace grainproof::opencl
