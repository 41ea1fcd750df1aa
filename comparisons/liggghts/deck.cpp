// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/deck.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <numbers>
#include <sstream>

#include "comparisons/liggghts/atom_types.hpp"

namespace grainproof::liggghts {
namespace {

constexpr std::size_t few_particles = 200;  // below, pairs are found without bins, whatever the domain's size

/// Full precision, so that LIGGGHTS reads the very number.
std::ostringstream exact_text() {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  return text;
}

template <class File>
File& exact(File& file) {
  file << std::setprecision(std::numeric_limits<double>::max_digits10);
  return file;
}

std::string name_with(const char* stem, int number) {
  return stem + std::to_string(number);
}

void write_data(const Scene& scene, const TypeTable& table, const std::filesystem::path& file) {
  std::ofstream out(file);
  exact(out) << "a scene\n\n"
             << scene.particles.size() << " atoms\n"
             << table.types.size() << " atom types\n";
  const char* axes = "xyz";
  for (int axis = 0; axis < 3; ++axis)
    out << scene.domain.lower[axis] << ' ' << scene.domain.upper[axis] << ' ' << axes[axis] << "lo "
        << axes[axis] << "hi\n";
  out << "\nAtoms\n\n";
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& p = scene.particles[i];
    out << i + 1 << ' ' << table.of_particle[i] + 1 << ' ' << p.diameter << ' '
        << scene.materials[static_cast<std::size_t>(p.material)].density << ' ' << p.position.x() << ' '
        << p.position.y() << ' ' << p.position.z() << '\n';
  }
  out << "\nVelocities\n\n";
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Vec3 v = scene.particles[i].fixed ? Vec3(Vec3::Zero()) : scene.particles[i].velocity;
    out << i + 1 << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << " 0 0 0\n";
  }
}

/// Steps after 0, and one that never comes twice, since the variable is read ahead.
void write_steps(const std::vector<std::int64_t>& steps, const std::filesystem::path& file) {
  std::ofstream out(file);
  for (std::size_t k = 1; k < steps.size(); ++k) out << steps[k] << '\n';
  out << "1e15\n1e15\n";
}

std::string set_up(const Scene& scene, int number) {
  std::ostringstream out = exact_text();
  out << "clear\natom_style granular\natom_modify map array sort 0 0.0\nboundary";
  for (int axis = 0; axis < 3; ++axis) out << (scene.domain.periodic(axis) ? " p" : " f");
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  out << "\nnewton off\ncommunicate single vel yes\nunits si\nprocessors * * 1\nread_data "
      << name_with("data.", number) << "\nneighbor " << 0.1 * largest
      << (scene.particles.size() < few_particles ? " nsq" : " bin") << "\nneigh_modify delay 0\n";
  return out.str();
}

std::string property(const char* name, const Scene& scene, const TypeTable& table,
                     double PairParameters::*member) {
  std::ostringstream out = exact_text();
  out << "fix " << name << " all property/global " << name << " peratomtypepair " << table.types.size();
  for (const AtomType& a : table.types)
    for (const AtomType& b : table.types) out << ' ' << pair_parameters(scene, a, b).*member;
  out << '\n';
  return out.str();
}

constexpr const char* model = "model hooke/stiffness tangential no_history";

std::string model_settings(const TypeTable& table) {
  return std::string(" absolute_damping on tangential_damping on limitForce ") +
         (table.no_tension ? "on" : "off");
}

/// no_history never uses kt, but hooke/stiffness wants it.
std::string contacts(const Scene& scene, const TypeTable& table) {
  return std::string("pair_style gran ") + model + model_settings(table) + "\npair_coeff * *\n" +
         property("kn", scene, table, &PairParameters::stiffness) +
         property("kt", scene, table, &PairParameters::stiffness) +
         property("gamman_abs", scene, table, &PairParameters::damping) +
         property("gammat_abs", scene, table, &PairParameters::tangential_damping) +
         property("coefficientFriction", scene, table, &PairParameters::friction);
}

struct AxisPlane {
  int axis;
  double at;
};

AxisPlane axis_plane(const Wall& wall) {
  int axis = 0;
  if (const auto* plane = std::get_if<Plane>(&wall.shape)) {
    plane->normal.cwiseAbs().maxCoeff(&axis);
    return {axis, plane->point[axis]};
  }
  const auto& rectangle = std::get<Rectangle>(wall.shape);
  (rectangle.upper - rectangle.lower).cwiseAbs().minCoeff(&axis);
  return {axis, rectangle.lower[axis]};
}

std::string walls(const Scene& scene, const TypeTable& table) {
  std::ostringstream out = exact_text();
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const AxisPlane plane = axis_plane(scene.walls[w]);
    out << "fix wall" << w << " all wall/gran " << model << " primitive type " << table.of_wall[w] + 1 << ' '
        << "xyz"[plane.axis] << "plane " << plane.at << model_settings(table) << '\n';
  }
  return out.str();
}

/// Spheres do not rotate: plain nve moves them, and leaves the spin that friction would give at zero.
std::string groups(const TypeTable& table) {
  std::string fixed;
  for (std::size_t t = 0; t < table.types.size(); ++t)
    if (!table.types[t].moves && table.types[t].mass > 0.0)
      fixed.append(1, ' ').append(std::to_string(t + 1));
  if (fixed.empty()) return "group moving union all\nfix motion moving nve\n";
  return std::string("group still type").append(fixed) +
         "\ngroup moving subtract all still\nfix motion moving nve\n" + "fix hold still freeze\n";
}

std::string gravity(const Scene& scene) {
  const Vec3& g = std::get<ConstantGravity>(scene.gravity).acceleration;
  if (g.norm() == 0.0) return {};
  std::ostringstream out = exact_text();
  out << "fix weight moving gravity " << g.norm() << " vector " << g.x() << ' ' << g.y() << ' ' << g.z()
      << '\n';
  return out.str();
}

/// docs/laws/fields.md: (m/τ)(u_f − u) = 3π μ_f d (u_f − u).
std::string drag(const Scene& scene, const TypeTable& table) {
  const auto* flow = std::get_if<UniformFlow>(&scene.flow);
  if (!flow) return {};
  std::ostringstream out = exact_text();
  for (std::size_t t = 0; t < table.types.size(); ++t) {
    if (!table.types[t].moves) continue;
    const double coefficient = 3.0 * std::numbers::pi * flow->viscosity * table.types[t].diameter;
    const Vec3 push = coefficient * flow->velocity;
    out << "group type" << t << " type " << t + 1 << "\nfix resist" << t << " type" << t << " viscous "
        << coefficient << "\nfix push" << t << " type" << t << " addforce " << push.x() << ' ' << push.y()
        << ' ' << push.z() << '\n';
  }
  return out.str();
}

std::string output_and_run(const Scene& scene, const Request& request, int number) {
  std::ostringstream out = exact_text();
  const std::string every = request.every_step ? "" : " every v_next";
  out << "timestep " << scene.run.step
      << "\nthermo_style custom step\nthermo 1000000000\nthermo_modify lost ignore\n";
  if (!request.every_step)
    out << "variable steps delete\nvariable next delete\nvariable steps file " << name_with("steps.", number)
        << "\nvariable next equal next(steps)\n";
  out << "dump frames all custom 1 " << dump_name(number) << " id x y z vx vy vz\ndump_modify frames" << every
      << " first yes sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"\nrun "
      << step_at_or_after(scene.run.end, scene.run.step) << "\nundump frames\nprint \"" << done_marker(number)
      << "\"\n";
  return out.str();
}

}  // namespace

std::string scene_deck(const Scene& scene, const Request& request, const std::filesystem::path& folder,
                       int number) {
  const TypeTable table = atom_types(scene);
  write_data(scene, table, folder / name_with("data.", number));
  write_steps(sample_steps(scene, request), folder / name_with("steps.", number));
  return set_up(scene, number) + contacts(scene, table) + walls(scene, table) + groups(table) +
         gravity(scene) + drag(scene, table) + output_and_run(scene, request, number);
}

std::string dump_name(int number) {
  return name_with("frames.", number);
}

std::string done_marker(int number) {
  return name_with("scene is through: ", number);
}

}  // namespace grainproof::liggghts
