// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/peer_deck.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>

#include "benchmarks/common/scenes.hpp"
#include "report/files.hpp"

namespace grainproof::bench {
namespace {

const double sphere_mass = density * std::numbers::pi / 6.0 * diameter * diameter * diameter;
const double pair_mass = 0.5 * sphere_mass;

/// N s/m, docs/laws/linear.md eq. 3.
double dashpot(double mass) {
  const double logarithm = std::log(restitution);
  return -2.0 * logarithm *
         std::sqrt(mass * stiffness / (std::pow(std::numbers::pi, 2) + logarithm * logarithm));
}

const HistoryFriction& friction_of(const Scene& scene) {
  return std::get<HistoryFriction>(scene.contacts.at(0, 0).friction);
}

/// LAMMPS takes dashpots a mass.
std::string lammps_style(const Scene& scene, double mass) {
  const HistoryFriction& law = friction_of(scene);
  const double rate = dashpot(mass) / mass;
  std::ostringstream out;
  out.precision(17);
  out << "hooke/history " << stiffness << ' ' << law.stiffness << ' ' << rate << ' '
      << law.damping_ratio * rate << ' ' << law.coefficient << " 1";
  return out.str();
}

std::string lammps_contacts(const Scene& scene) {
  std::string text = "pair_style gran/" + lammps_style(scene, pair_mass) + "\npair_coeff * *\n";
  if (!scene.walls.empty())
    text += "fix floor all wall/gran " + lammps_style(scene, sphere_mass) + " zplane 0.0 NULL\n";
  return text;
}

/// Of two types: spheres, and the floor.
std::string liggghts_property(const char* name, double of_pairs, double of_floor) {
  std::ostringstream out;
  out.precision(17);
  out << "fix " << name << " all property/global " << name << " peratomtypepair 2 " << of_pairs << ' '
      << of_floor << ' ' << of_floor << ' ' << of_floor << '\n';
  return out.str();
}

std::string liggghts_contacts(const Scene& scene) {
  const HistoryFriction& law = friction_of(scene);
  const double ratio = law.damping_ratio;
  const std::string model = "model hooke/stiffness tangential history";
  const std::string settings = " absolute_damping on tangential_damping on limitForce off\n";
  std::string text =
      "pair_style gran " + model + settings + "pair_coeff * *\n" +
      liggghts_property("kn", stiffness, stiffness) + liggghts_property("kt", law.stiffness, law.stiffness) +
      liggghts_property("gamman_abs", dashpot(pair_mass), dashpot(sphere_mass)) +
      liggghts_property("gammat_abs", ratio * dashpot(pair_mass), ratio * dashpot(sphere_mass)) +
      liggghts_property("coefficientFriction", law.coefficient, law.coefficient);
  if (!scene.walls.empty())
    text += "fix floor all wall/gran " + model + " primitive type 2 zplane 0.0" + settings;
  return text;
}

}  // namespace

std::string peer_contacts(PeerProgram program, const Scene& scene) {
  return (program == PeerProgram::lammps ? lammps_contacts(scene) : liggghts_contacts(scene)) +
         (scene.walls.empty() ? "" : "fix weight all gravity 9.81 vector 0 0 -1\n");
}

void write_peer_data(const Scene& scene, const std::filesystem::path& file) {
  std::ofstream out(file);
  out.precision(std::numeric_limits<double>::max_digits10);
  out << "a scene\n\n" << scene.particles.size() << " atoms\n2 atom types\n";
  for (int axis = 0; axis < 3; ++axis)
    out << scene.domain.lower[axis] << ' ' << scene.domain.upper[axis] << ' ' << "xyz"[axis] << "lo "
        << "xyz"[axis] << "hi\n";
  out << "\nAtoms\n\n";
  for (const Particle& p : scene.particles)
    out << p.id << " 1 " << p.diameter << ' ' << density << ' ' << p.position.x() << ' ' << p.position.y()
        << ' ' << p.position.z() << '\n';
  out << "\nVelocities\n\n";
  for (const Particle& p : scene.particles)
    out << p.id << ' ' << p.velocity.x() << ' ' << p.velocity.y() << ' ' << p.velocity.z() << " 0 0 0\n";
  out.flush();
  report::require_written(out, file);
}

std::string peer_deck(PeerProgram program, const Scene& scene, double skin, std::int64_t warm_up,
                      std::int64_t steps) {
  const bool lammps = program == PeerProgram::lammps;
  const bool floor = !scene.walls.empty();
  std::ostringstream out;
  out.precision(17);
  out << (lammps ? "atom_style sphere\n" : "soft_particles yes\nhard_particles yes\natom_style granular\n")
      << "atom_modify map array\nboundary p p " << (floor ? "f" : "p") << "\nnewton off\n"
      << (lammps ? "comm_modify vel yes\n" : "communicate single vel yes\n") << "units si\n"
      << (floor ? "processors * * 1\n" : "") << "read_data data\nneighbor " << skin
      << " bin\nneigh_modify delay 0\n"
      << peer_contacts(program, scene) << "fix motion all nve/sphere\ntimestep " << time_step
      << "\nthermo 1000000000\nrun " << warm_up << "\nrun " << steps << '\n';
  return out.str();
}

}  // namespace grainproof::bench
