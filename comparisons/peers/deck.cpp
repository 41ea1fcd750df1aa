// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/peers/deck.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <limits>
#include <numbers>

namespace grainproof::peers {
namespace {

constexpr std::size_t few_particles = 200;  // below, pairs are found without bins, whatever the domain's size

template <class File>
File& exact(File& file) {
  file << std::setprecision(std::numeric_limits<double>::max_digits10);
  return file;
}

bool turns(const Scene& scene, const Particle& particle) {
  return scene.rotation && !particle.fixed;
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
    const Vec3 w =
        turns(scene, scene.particles[i]) ? scene.particles[i].angular_velocity : Vec3(Vec3::Zero());
    out << i + 1 << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << ' ' << w.x() << ' ' << w.y() << ' '
        << w.z() << '\n';
  }
}

/// Steps after 0, and one that never comes twice, since the variable is read ahead.
void write_steps(const std::vector<std::int64_t>& steps, const std::filesystem::path& file) {
  std::ofstream out(file);
  for (std::size_t k = 1; k < steps.size(); ++k) out << steps[k] << '\n';
  out << "1e15\n1e15\n";
}

std::string gravity(const Scene& scene) {
  const Vec3& g = std::get<ConstantGravity>(scene.gravity).acceleration;
  if (g.norm() == 0.0) return {};
  std::ostringstream out = exact_text();
  out << "fix weight moving gravity " << g.norm() << " vector " << g.x() << ' ' << g.y() << ' ' << g.z()
      << '\n';
  return out.str();
}

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

}  // namespace

std::ostringstream exact_text() {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10);
  return text;
}

std::string name_with(const char* stem, int number) {
  return stem + std::to_string(number);
}

void write_inputs(const Scene& scene, const Request& request, const TypeTable& table,
                  const std::filesystem::path& folder, int number) {
  write_data(scene, table, folder / name_with("data.", number));
  write_steps(sample_steps(scene, request), folder / name_with("steps.", number));
}

std::string set_up(const Scene& scene, const char* talk, bool bins, int number) {
  std::ostringstream out = exact_text();
  out << "atom_modify map array sort 0 0.0\nboundary";
  for (int axis = 0; axis < 3; ++axis) out << (scene.domain.periodic(axis) ? " p" : " f");
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  out << "\nnewton off\n"
      << talk << "\nunits si\nprocessors * * 1\nread_data " << name_with("data.", number) << "\nneighbor "
      << 0.1 * largest << (scene.particles.size() < few_particles && !bins ? " nsq" : " bin")
      << "\nneigh_modify delay 0\n";
  return out.str();
}

std::string motion(const Scene& scene, const TypeTable& table) {
  const std::string integration =
      scene.rotation ? "fix motion moving nve/sphere\n" : "fix motion moving nve\n";
  std::string fixed;
  for (std::size_t t = 0; t < table.types.size(); ++t)
    if (!table.types[t].moves && table.types[t].mass > 0.0)
      fixed.append(1, ' ').append(std::to_string(t + 1));
  if (fixed.empty()) return "group moving union all\n" + integration;
  return std::string("group still type").append(fixed) + "\ngroup moving subtract all still\n" + integration +
         "fix hold still freeze\n";
}

std::string fields(const Scene& scene, const TypeTable& table) {
  return gravity(scene) + drag(scene, table);
}

std::string output_and_run(const Scene& scene, const Request& request, const char* format, int number) {
  std::ostringstream out = exact_text();
  const std::string every = request.every_step ? "" : " every v_next";
  out << "timestep " << scene.run.step
      << "\nthermo_style custom step\nthermo 1000000000\nthermo_modify lost ignore\n";
  if (!request.every_step)
    out << "variable steps delete\nvariable next delete\nvariable steps file " << name_with("steps.", number)
        << "\nvariable next equal next(steps)\n";
  out << "dump frames all custom 1 " << dump_name(number) << " id x y z vx vy vz"
      << (scene.rotation ? " omegax omegay omegaz" : "") << "\ndump_modify frames" << every
      << " first yes sort id " << format << " \"%d";
  for (int column = 0; column < (scene.rotation ? 9 : 6); ++column) out << " %.17g";
  out << "\"\nrun " << step_at_or_after(scene.run.end, scene.run.step) << "\nundump frames\nprint \""
      << done_marker(number) << "\"\n";
  return out.str();
}

std::string dump_name(int number) {
  return name_with("frames.", number);
}

std::string done_marker(int number) {
  return name_with("scene is through: ", number);
}

}  // namespace grainproof::peers
