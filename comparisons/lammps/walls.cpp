// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/lammps/walls.hpp"

#include <numbers>

#include "comparisons/peers/atom_types.hpp"
#include "comparisons/peers/deck.hpp"
#include "comparisons/peers/walls.hpp"

namespace grainproof::lammps {
namespace {

bool is_turning(const Wall& wall) {
  return std::holds_alternative<Rotating>(wall.motion);
}

constexpr const char* within_itself = "LAMMPS' walls move within themselves along an axis only";

/// Its own turning wall (zcylinder with shear) moves across itself too, so a turning one is a region.
Support cylinder_support(const Scene& scene, const Cylinder& round, bool turns) {
  if (!peers::lengthwise(round)) return Support::no("LAMMPS' cylinders lie along the axes");
  const bool primitive = peers::lengthwise(round) == 2 && round.point.x() == 0.0 && round.point.y() == 0.0 &&
                         round.side == Cylinder::Side::inside;
  if (!turns && !primitive)
    return Support::no("LAMMPS' cylinder that does not turn is about the z axis, with particles inside");
  for (const ContactLaws& laws : peers::all_laws(scene))
    if (std::holds_alternative<HertzNormal>(laws.normal))
      return Support::no("LAMMPS counts a cylinder's own radius into the effective one of a Hertz contact");
  return {};
}

/// Starting at rest, at one end of its way.
bool is_wiggle(const Vibrating& moves) {
  return moves.phase == -std::numbers::pi / 2.0 && peers::axis_speed(moves.amplitude).has_value();
}

Support motion_support(const WallMotion& motion, int axis, bool round) {
  return std::visit(
      Overloaded{[](const Still&) { return Support{}; },
                 [&](const Translating& moves) {
                   const auto along = peers::axis_speed(moves.velocity);
                   return along && (along->axis == axis) == round ? Support{} : Support::no(within_itself);
                 },
                 [&](const Rotating&) {
                   return round ? Support{} : Support::no("LAMMPS has no flat wall that turns in its plane");
                 },
                 [&](const Vibrating& moves) {
                   return is_wiggle(moves) && !round
                              ? Support{}
                              : Support::no(
                                    "LAMMPS' wiggle is of flat walls along an axis, from rest (phase −π/2)");
                 }},
      motion);
}

std::string name_of(const char* what, std::size_t wall) {
  return what + std::to_string(wall);
}

std::string moving(const Wall& wall) {
  std::ostringstream out = peers::exact_text();
  if (const auto* moves = std::get_if<Translating>(&wall.motion)) {
    const peers::AxisSpeed along = *peers::axis_speed(moves->velocity);
    out << " shear "
        << "xyz"[along.axis] << ' ' << along.speed;
  } else if (const auto* shakes = std::get_if<Vibrating>(&wall.motion)) {
    const peers::AxisSpeed along = *peers::axis_speed(shakes->amplitude);
    out << " wiggle "
        << "xyz"[along.axis] << ' ' << along.speed << ' ' << 1.0 / shakes->frequency;
  }
  return out.str();
}

}  // namespace

Support wall_support(const Scene& scene, const Wall& wall) {
  const auto plane = peers::axis_plane(wall, scene.domain);
  const auto* round = std::get_if<Cylinder>(&wall.shape);
  if (!plane && !round)
    return Support::no(std::holds_alternative<Plane>(wall.shape) ? "LAMMPS' flat walls lie along the axes"
                                                                 : "LAMMPS' flat walls have no edges");
  if (const Support support = round ? cylinder_support(scene, *round, is_turning(wall)) : Support{}; !support)
    return support;
  if (const Support support = motion_support(wall.motion, plane ? plane->axis : 2, round != nullptr);
      !support)
    return support;
  return peers::open_side_support(scene, wall, "LAMMPS");
}

std::string wall_region(const Scene& scene, std::size_t wall) {
  const Wall& own = scene.walls[wall];
  if (!is_turning(own)) return {};
  const auto& round = std::get<Cylinder>(own.shape);
  const int axis = *peers::lengthwise(round);
  const double end = 10.0 * scene.domain.extent().maxCoeff();  // beyond every particle, so no ends are met
  std::ostringstream out = peers::exact_text();
  out << "variable " << name_of("angle", wall) << " equal " << std::get<Rotating>(own.motion).rate
      << "*step*dt\nregion " << name_of("drum", wall) << " cylinder "
      << "xyz"[axis];
  for (int other = 0; other < 3; ++other)
    if (other != axis) out << ' ' << round.point[other];
  out << ' ' << round.radius << ' ' << scene.domain.lower[axis] - end << ' ' << scene.domain.upper[axis] + end
      << " side " << (round.side == Cylinder::Side::inside ? "in" : "out") << " open 1 open 2 rotate v_"
      << name_of("angle", wall);
  for (const Vec3& vector : {round.point, round.axis})
    out << ' ' << vector.x() << ' ' << vector.y() << ' ' << vector.z();
  out << '\n';
  return out.str();
}

std::string wall_fix(const Scene& scene, std::size_t wall, const std::string& style) {
  const Wall& own = scene.walls[wall];
  if (is_turning(own)) return "wall/gran/region " + style + " region " + name_of("drum", wall);
  std::ostringstream out = peers::exact_text();
  out << "wall/gran " << style << ' ';
  if (const auto plane = peers::axis_plane(own, scene.domain))
    out << "xyz"[plane->axis] << "plane " << plane->at << " NULL";
  else
    out << "zcylinder " << std::get<Cylinder>(own.shape).radius;
  return out.str() + moving(own);
}

}  // namespace grainproof::lammps
