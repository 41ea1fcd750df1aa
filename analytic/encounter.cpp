// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/encounter.hpp"

#include <cmath>
#include <utility>

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic {
namespace {

/// Positions and velocities are given to a rounding each; a direction from them to about this.
constexpr double direction_roundoff = 1e-9;

Recognised no(std::string because) {
  return {Support::no(std::move(because)), {}};
}

Vec3 across(const Vec3& vector, const Vec3& normal) {
  return vector - vector.dot(normal) * normal;
}

double mass_of(const Scene& scene, const Particle& particle) {
  return sphere_mass(scene.materials[particle.material].density, particle.diameter);
}

void set_relative_motion(Encounter& e, const Vec3& velocity, const Vec3& gravity, double distance,
                         double reach) {
  e.gap = {distance - e.touching, velocity.dot(e.normal)};
  e.slip = across(velocity, e.normal);
  e.gravity = gravity.dot(e.normal);
  e.gravity_across = across(gravity, e.normal);
  e.reach = std::holds_alternative<NoCohesion>(e.laws.cohesion) ? 0.0 : reach;
}

/// Distance of a point to a wall's face along a unit normal that points to it.
struct Face {
  double distance;
  Vec3 normal;
};

Face face_of_cylinder(const Cylinder& cylinder, const Vec3& point) {
  const Vec3 from_point = point - cylinder.point;
  const Vec3 off_axis = from_point - from_point.dot(cylinder.axis) * cylinder.axis;
  const double inward = cylinder.side == Cylinder::Side::inside ? 1.0 : -1.0;
  return {inward * (cylinder.radius - off_axis.norm()), -inward * off_axis.normalized()};
}

Face face_of(const WallShape& shape, const Vec3& point) {
  if (const auto* plane = std::get_if<Plane>(&shape))
    return {(point - plane->point).dot(plane->normal), plane->normal};
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return face_of_cylinder(*cylinder, point);
  const auto& rectangle = std::get<Rectangle>(shape);
  const Vec3 extent = rectangle.upper - rectangle.lower;
  Eigen::Index axis = 0;
  extent.minCoeff(&axis);
  const double side = point[axis] - rectangle.lower[axis];
  return {std::abs(side), Vec3::Unit(axis) * (side < 0.0 ? -1.0 : 1.0)};
}

Recognised with_wall(const Scene& scene, const Vec3& gravity) {
  const Particle& sphere = scene.particles.front();
  const Wall& wall = scene.walls.front();
  if (sphere.fixed) return no("nothing moves");
  if (!scene.contacts.has(sphere.material, wall.material))
    return no("the sphere and the wall have no contact laws");
  const auto velocity = wall_velocity(wall);
  if (!velocity) return no("the wall vibrates or turns");
  Encounter e;
  const Face face = face_of(wall.shape, sphere.position);
  if (!(face.distance > 0.0)) return no("the sphere's centre is not in front of the wall");
  if (const auto* rectangle = std::get_if<Rectangle>(&wall.shape)) e.rectangle = *rectangle;
  e.normal = face.normal;
  e.laws = scene.contacts.at(sphere.material, wall.material);
  e.mass = mass_of(scene, sphere);
  e.touching = 0.5 * sphere.diameter;
  e.centre = sphere.position - face.distance * face.normal;
  e.centre_velocity = *velocity;
  set_relative_motion(e, sphere.velocity - *velocity, gravity, face.distance,
                      0.5 * (sphere.effect_diameter - sphere.diameter));
  if (std::holds_alternative<Cylinder>(wall.shape) && !head_on(e))
    return no("the wall is a cylinder, and the sphere does not move straight towards it or away from it");
  if (!over_wall(e, Vec3::Zero())) return no("the sphere does not stand over the wall's face");
  return {{}, e};
}

void place_centre(Encounter& e, const Scene& scene, const Vec3& gravity) {
  const Particle& one = scene.particles[*e.first];
  const Particle& two = scene.particles[e.second];
  if (one.fixed) {
    e.mass = mass_of(scene, two);
    e.centre = one.position;
    return;
  }
  const double m1 = mass_of(scene, one), m2 = mass_of(scene, two);
  e.mass = effective_mass(m1, m2);
  e.first_share = m2 / (m1 + m2);
  e.second_share = m1 / (m1 + m2);
  e.centre = e.second_share * one.position + e.first_share * two.position;
  e.centre_velocity = e.second_share * one.velocity + e.first_share * two.velocity;
  e.centre_acceleration = gravity;
}

Recognised of_pair(const Scene& scene, const Vec3& gravity) {
  Encounter e;
  e.first = 0;
  e.second = 1;
  if (scene.particles[1].fixed) std::swap(*e.first, e.second);
  const Particle& one = scene.particles[*e.first];
  const Particle& two = scene.particles[e.second];
  if (two.fixed) return no("nothing moves");
  if (one.fixed && !one.velocity.isZero(0.0)) return no("a fixed particle has a velocity");
  if (!scene.contacts.has(one.material, two.material)) return no("the two spheres have no contact laws");
  const Vec3 separation = two.position - one.position;
  if (separation.isZero(0.0)) return no("the two centres coincide");
  e.normal = separation.normalized();
  e.laws = scene.contacts.at(one.material, two.material);
  e.touching = 0.5 * (one.diameter + two.diameter);
  place_centre(e, scene, gravity);
  set_relative_motion(e, two.velocity - one.velocity, one.fixed ? gravity : Vec3::Zero(), separation.norm(),
                      0.5 * (one.effect_diameter + two.effect_diameter) - e.touching);
  return {{}, e};
}

Recognised without_rolling(Recognised found) {
  if (!found.support || std::holds_alternative<NoRolling>(found.encounter.laws.rolling)) return found;
  return no("rolling is resisted");
}

}  // namespace

double Encounter::cohesion_stiffness() const {
  const auto* law = std::get_if<LinearCohesion>(&laws.cohesion);
  return law && reach > 0.0 ? law->stiffness : 0.0;
}

Recognised recognise_bodies(const Scene& scene) {
  return without_rolling(recognise_rolling(scene));
}

Recognised recognise_rolling(const Scene& scene) {
  if (!scene.remembered.empty()) return no("contacts remember something at the start");
  if (scene.orientation != OrientationUpdate::none) return no("orientations are asked for");
  if (!std::holds_alternative<NoFlow>(scene.flow)) return no("a fluid acts on the particles");
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  if (!gravity) return no("gravity is not constant");
  if (scene.particles.size() == 1 && scene.walls.size() == 1) return with_wall(scene, gravity->acceleration);
  if (scene.particles.size() == 2 && scene.walls.empty()) return of_pair(scene, gravity->acceleration);
  return no("found " + std::to_string(scene.particles.size()) + " particles and " +
            std::to_string(scene.walls.size()) + " walls; expected one and one, or two particles alone");
}

Recognised recognise(const Scene& scene) {
  Recognised found = recognise_bodies(scene);
  if (!found.support) return found;
  const Encounter& e = found.encounter;
  if (!std::holds_alternative<LinearNormal>(e.laws.normal)) return no("the contact is not linear but Hertz'");
  if (!scene.rotation || std::holds_alternative<Frictionless>(e.laws.friction)) return found;
  if (spins_rub(scene, e)) return no("a particle spins, and friction acts");
  return head_on(e) ? found : no("friction makes the bodies turn");
}

std::optional<Vec3> wall_velocity(const Wall& wall) {
  if (const auto* translating = std::get_if<Translating>(&wall.motion)) return translating->velocity;
  return std::holds_alternative<Still>(wall.motion) ? std::optional<Vec3>(Vec3::Zero()) : std::nullopt;
}

bool spins_rub(const Scene& scene, const Encounter& e) {
  const Particle& two = scene.particles[e.second];
  Vec3 of_surfaces = 0.5 * two.diameter * two.angular_velocity, of_bodies = two.angular_velocity;
  if (e.first) {
    const Particle& one = scene.particles[*e.first];
    of_surfaces += 0.5 * one.diameter * one.angular_velocity;
    of_bodies += one.angular_velocity;
  }
  const auto* history = std::get_if<HistoryFriction>(&e.laws.friction);
  const bool shortened = history && history->arm == TorqueArm::overlap;
  return !of_surfaces.cross(e.normal).isZero(0.0) || (shortened && !of_bodies.cross(e.normal).isZero(0.0));
}

bool starts_in_contact(const Encounter& e) {
  return e.gap.position < -1e-12 * (e.touching + e.centre.norm());
}

bool head_on(const Encounter& e) {
  return e.slip.norm() <= direction_roundoff * std::hypot(e.gap.velocity, e.slip.norm()) &&
         e.gravity_across.norm() <= direction_roundoff * std::hypot(e.gravity, e.gravity_across.norm());
}

Frame frame_of(const Scene& scene, double time) {
  Frame frame;
  frame.step = step_at_or_after(time, scene.run.step);
  frame.time = time;
  for (const Particle& particle : scene.particles) {
    frame.position.push_back(particle.position);
    frame.velocity.push_back(particle.velocity);
    if (scene.rotation) frame.angular_velocity.push_back(particle.angular_velocity);
  }
  return frame;
}

Frame frame_of(const Scene& scene, const Encounter& e, const Motion& gap, const Slip& slip, double time) {
  Frame frame = frame_of(scene, time);
  const Vec3 separation = (e.touching + gap.position) * e.normal + slip.displacement;
  const Vec3 separating = gap.velocity * e.normal + slip.velocity;
  const Vec3 centre = e.centre + (e.centre_velocity + 0.5 * time * e.centre_acceleration) * time;
  const Vec3 drifting = e.centre_velocity + time * e.centre_acceleration;
  frame.position[e.second] = centre + e.second_share * separation;
  frame.velocity[e.second] = drifting + e.second_share * separating;
  if (e.first && e.first_share > 0.0) {
    frame.position[*e.first] = centre - e.first_share * separation;
    frame.velocity[*e.first] = drifting - e.first_share * separating;
  }
  return frame;
}

bool over_wall(const Encounter& e, const Vec3& displacement) {
  if (!e.rectangle) return true;
  const Vec3 foot = e.centre + displacement;
  for (int axis = 0; axis < 3; ++axis) {
    if (e.rectangle->upper[axis] == e.rectangle->lower[axis]) continue;
    if (foot[axis] < e.rectangle->lower[axis] || foot[axis] > e.rectangle->upper[axis]) return false;
  }
  return true;
}

}  // namespace grainproof::analytic
