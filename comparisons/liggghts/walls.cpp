// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/walls.hpp"

#include <array>
#include <fstream>
#include <iomanip>
#include <limits>

#include "comparisons/peers/deck.hpp"
#include "comparisons/peers/walls.hpp"

namespace grainproof::liggghts {
namespace {

Support motion_support(const WallMotion& motion, const WallShape& shape, int axis) {
  if (std::holds_alternative<Still>(motion)) return {};
  if (std::holds_alternative<Rotating>(motion))
    return Support::no(
        std::holds_alternative<Cylinder>(shape)
            ? "LIGGGHTS turns a cylinder's surface as fast as it would move at the sphere's centre"
            : "LIGGGHTS has no flat wall that turns in its plane");
  const auto* moves = std::get_if<Translating>(&motion);
  const auto along = moves ? peers::axis_speed(moves->velocity) : std::nullopt;
  const bool within = along && (along->axis == axis) == std::holds_alternative<Cylinder>(shape);
  return within && !std::holds_alternative<Rectangle>(shape)
             ? Support{}
             : Support::no("LIGGGHTS' primitive walls move within themselves along an axis only");
}

void write_stl(const Rectangle& flat, const std::filesystem::path& file) {
  int across = 0;
  (flat.upper - flat.lower).minCoeff(&across);
  Vec3 beside = flat.lower;
  Vec3 above = flat.lower;
  beside[(across + 1) % 3] = flat.upper[(across + 1) % 3];
  above[(across + 2) % 3] = flat.upper[(across + 2) % 3];
  const Vec3 normal = Vec3::Unit(across);
  std::ofstream out(file);
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << "solid rectangle\n";
  for (const std::array<Vec3, 3>& triangle :
       {std::array{flat.lower, beside, flat.upper}, std::array{flat.lower, flat.upper, above}}) {
    out << "facet normal " << normal.transpose() << "\nouter loop\n";
    for (const Vec3& corner : triangle)
      out << "vertex " << corner.x() << ' ' << corner.y() << ' ' << corner.z() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid rectangle\n";
}

/// `xplane 0.1`, or `zcylinder` with its radius and where its axis is along the next two.
std::string primitive(const Scene& scene, const Wall& wall) {
  std::ostringstream out = peers::exact_text();
  if (const auto plane = peers::axis_plane(wall, scene.domain)) {
    out << "xyz"[plane->axis] << "plane " << plane->at;
    return out.str();
  }
  const auto& round = std::get<Cylinder>(wall.shape);
  const int axis = *peers::lengthwise(round);
  out << "xyz"[axis] << "cylinder " << round.radius;
  out << ' ' << round.point[(axis + 1) % 3] << ' ' << round.point[(axis + 2) % 3];
  return out.str();
}

std::string shear(const WallMotion& motion) {
  const auto* moves = std::get_if<Translating>(&motion);
  if (!moves) return {};
  const peers::AxisSpeed along = *peers::axis_speed(moves->velocity);
  std::ostringstream out = peers::exact_text();
  out << " shear "
      << "xyz"[along.axis] << ' ' << along.speed;
  return out.str();
}

}  // namespace

Support wall_support(const Scene& scene, const Wall& wall) {
  if (is_mesh(scene, wall))
    return std::holds_alternative<Still>(wall.motion)
               ? Support{}
               : Support::no("LIGGGHTS is asked for rectangles that stand still only");
  const auto plane = peers::axis_plane(wall, scene.domain);
  const auto* round = std::get_if<Cylinder>(&wall.shape);
  if (!plane && !round) return Support::no("LIGGGHTS' flat walls lie along the axes");
  if (round && !peers::lengthwise(*round)) return Support::no("LIGGGHTS' cylinders lie along the axes");
  const int axis = plane ? plane->axis : *peers::lengthwise(*round);
  if (const Support support = motion_support(wall.motion, wall.shape, axis); !support) return support;
  return peers::open_side_support(scene, wall, "LIGGGHTS");
}

bool is_mesh(const Scene& scene, const Wall& wall) {
  return std::holds_alternative<Rectangle>(wall.shape) && !peers::axis_plane(wall, scene.domain);
}

std::string wall_commands(const Scene& scene, const std::vector<std::size_t>& types, const WallModel& model,
                          const std::filesystem::path& folder, int number) {
  std::string commands;
  std::vector<std::string> meshes;  // all in one fix: LIGGGHTS takes no more
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const Wall& wall = scene.walls[w];
    const std::string type = std::to_string(types[w] + 1);
    if (!is_mesh(scene, wall)) {
      commands += "fix wall" + std::to_string(w) + " all wall/gran " + model.before + " primitive type " +
                  type + ' ' + primitive(scene, wall) + shear(wall.motion) + model.after + '\n';
      continue;
    }
    meshes.push_back("mesh" + std::to_string(w));
    const std::string file = meshes.back() + peers::name_with(".", number) + ".stl";
    write_stl(std::get<Rectangle>(wall.shape), folder / file);
    commands += "fix " + meshes.back() + " all mesh/surface file " + file + " type " + type + '\n';
  }
  if (meshes.empty()) return commands;
  commands += "fix meshes all wall/gran " + model.before + " mesh n_meshes " + std::to_string(meshes.size()) +
              " meshes";
  for (const std::string& mesh : meshes) commands += ' ' + mesh;
  return commands + model.after + '\n';
}

}  // namespace grainproof::liggghts
