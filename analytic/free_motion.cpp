// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/free_motion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analytic/contact_scales.hpp"
#include "analytic/possible_contacts.hpp"

namespace grainproof::analytic {
namespace {

constexpr std::size_t most_particles = 1000;  // every pair is looked at

struct Interval {
  double low;
  double high;
};

/// Motion per unit mass: v' = g + (u_f − v)/τ along any direction.
class Flight {
 public:
  Flight(const Particle& particle, double rate, const Vec3& gravity, const Vec3& stream)
      : particle_(particle), rate_(rate), force_(gravity + rate * stream) {}

  LinearMotion along(const Vec3& direction) const {
    const double moving = particle_.fixed ? 0.0 : 1.0;
    return {{1.0, 0.0, rate_, moving * force_.dot(direction)},
            {particle_.position.dot(direction), moving * particle_.velocity.dot(direction)}};
  }

  /// Where the particle goes along a direction: between its turn, its start and its end.
  Interval range(const Vec3& direction, double until) const {
    const LinearMotion motion = along(direction);
    const double start = motion.start().position, end = motion.at(until).position;
    Interval range{std::min(start, end), std::max(start, end)};
    if (const auto turn = motion.turning_time(); turn && *turn < until) {
      range.low = std::min(range.low, motion.at(*turn).position);
      range.high = std::max(range.high, motion.at(*turn).position);
    }
    return range;
  }

  const Particle& particle() const { return particle_; }
  double rate() const { return rate_; }

 private:
  Particle particle_;
  double rate_;
  Vec3 force_;
};

bool boxes_apart(const Flight& one, const Flight& two, double distance, double until) {
  for (int axis = 0; axis < 3; ++axis) {
    const Interval a = one.range(Vec3::Unit(axis), until), b = two.range(Vec3::Unit(axis), until);
    if (b.low - a.high > distance || a.low - b.high > distance) return true;
  }
  return false;
}

/// Two free particles of one relaxation time: their separation runs straight, by w0 τ (1 − e^{−t/τ}).
bool straight_paths_apart(const Flight& one, const Flight& two, double distance, double until) {
  if (one.particle().fixed || two.particle().fixed || one.rate() != two.rate()) return false;
  const Vec3 from = two.particle().position - one.particle().position;
  const Vec3 drift = two.particle().velocity - one.particle().velocity;
  const double run = one.rate() > 0.0 ? -std::expm1(-one.rate() * until) / one.rate() : until;
  const double nearest =
      drift.isZero(0.0) ? 0.0 : std::clamp(-from.dot(drift) / drift.squaredNorm(), 0.0, run);
  return (from + nearest * drift).norm() > distance;
}

/// By a box around the path: inside, all its corners; outside, one of its sides across the axis.
bool clear_of_cylinder(const Flight& flight, const Cylinder& cylinder, double distance, double until) {
  const Vec3 one = cylinder.axis.unitOrthogonal(), other = cylinder.axis.cross(one);
  const auto off_axis = [&](const Vec3& direction) {
    const Interval range = flight.range(direction, until);
    const double axis = cylinder.point.dot(direction);
    return Interval{range.low - axis, range.high - axis};
  };
  const Interval a = off_axis(one), b = off_axis(other);
  const auto furthest = [](const Interval& i) { return std::max(std::abs(i.low), std::abs(i.high)); };
  const auto nearest = [](const Interval& i) { return std::max({0.0, i.low, -i.high}); };
  if (cylinder.side == Cylinder::Side::inside)
    return std::hypot(furthest(a), furthest(b)) < cylinder.radius - distance;
  return std::hypot(nearest(a), nearest(b)) > cylinder.radius + distance;
}

bool clear_of_wall(const Flight& flight, const WallShape& shape, double distance, double until) {
  const auto beyond = [&](const Vec3& normal, const Vec3& point) {
    return flight.range(normal, until).low - point.dot(normal) > distance;
  };
  if (const auto* plane = std::get_if<Plane>(&shape)) return beyond(plane->normal, plane->point);
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    return clear_of_cylinder(flight, *cylinder, distance, until);
  const auto& rectangle = std::get<Rectangle>(shape);
  for (int axis = 0; axis < 3; ++axis)
    if (beyond(Vec3::Unit(axis), rectangle.upper) || beyond(-Vec3::Unit(axis), rectangle.lower)) return true;
  return false;
}

/// Turning within itself, a wall stays where it is.
bool moves(const Wall& wall) {
  return std::holds_alternative<Translating>(wall.motion) || std::holds_alternative<Vibrating>(wall.motion);
}

std::string what_might_meet(const Scene& scene, const std::vector<Flight>& flights, double until) {
  for (std::size_t a = 0; a < flights.size(); ++a) {
    const Particle& one = flights[a].particle();
    for (const Wall& wall : scene.walls) {
      if (!one.fixed && moves(wall)) return "wall " + wall.name + " moves";
      if (!one.fixed && !clear_of_wall(flights[a], wall.shape, 0.5 * one.effect_diameter, until))
        return "particle " + std::to_string(one.id) + " might meet wall " + wall.name;
    }
    for (std::size_t b = a + 1; b < flights.size(); ++b) {
      const Particle& two = flights[b].particle();
      const double distance = 0.5 * (one.effect_diameter + two.effect_diameter);
      if (!straight_paths_apart(flights[a], flights[b], distance, until) &&
          !boxes_apart(flights[a], flights[b], distance, until))
        return "particles " + std::to_string(one.id) + " and " + std::to_string(two.id) + " might meet";
    }
  }
  return {};
}

/// From no turn at all, about a steady axis (rotation.12).
Quaternion turned(const Vec3& angle) {
  const double size = angle.norm();
  return size > 0.0 ? Quaternion(Eigen::AngleAxisd(size, angle / size)) : Quaternion::Identity();
}

/// Nothing in flight changes a spin.
Frame frame_of_flights(const std::vector<Flight>& flights, double time, double step, bool rotation,
                       bool orientation) {
  Frame frame;
  frame.step = step_at_or_after(time, step);
  frame.time = time;
  for (const Flight& flight : flights) {
    Vec3 position, velocity;
    for (int axis = 0; axis < 3; ++axis) {
      const Motion motion = flight.along(Vec3::Unit(axis)).at(time);
      position[axis] = motion.position;
      velocity[axis] = motion.velocity;
    }
    frame.position.push_back(position);
    frame.velocity.push_back(velocity);
    const Vec3& spin = flight.particle().angular_velocity;
    if (rotation) frame.angular_velocity.push_back(spin);
    if (orientation) frame.orientation.push_back(turned(time * spin));
  }
  return frame;
}

}  // namespace

Solution free_motion(const Scene& scene, const Vec3& gravity, const UniformFlow& flow, double until) {
  if (scene.particles.size() > most_particles)
    return Solution::no("found " + std::to_string(scene.particles.size()) +
                        " particles; expected at most 1000");
  std::vector<Flight> flights;
  for (const Particle& particle : scene.particles) {
    const double rate = drag_rate(flow, scene.materials[particle.material].density, particle.diameter);
    flights.emplace_back(particle, rate, gravity, flow.velocity);
  }
  if (const std::string because = what_might_meet(scene, flights, until); !because.empty())
    return Solution::no(because);
  Solution solution;
  solution.frame_at = [flights, step = scene.run.step, rotation = scene.rotation,
                       orientation = scene.orientation != OrientationUpdate::none](double time) {
    return frame_of_flights(flights, time, step, rotation, orientation);
  };
  return solution;
}

}  // namespace grainproof::analytic
