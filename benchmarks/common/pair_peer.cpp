// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/pair_peer.hpp"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <sstream>

#include "benchmarks/common/peer_subject.hpp"
#include "benchmarks/common/scenes.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

/// Dashpot a mass, 1/s, that gives a pair of usual spheres the gas's restitution.
double damping_rate(const PairGas& gas) {
  const double mass = 0.5 * density * std::numbers::pi / 6.0 * std::pow(diameter, 3);
  return -2.0 * std::log(gas.restitution) / contact_time(mass, gas.restitution);
}

/// exp(−γ t_c/2) with the pair's own ω_d² = k/m − γ²/4.
double restitution_at(double rate, double mass) {
  const double omega = std::sqrt(stiffness / mass - 0.25 * rate * rate);
  return std::exp(-0.5 * rate * std::numbers::pi / omega);
}

std::string lammps_style(const PairGas& gas) {
  std::ostringstream out;
  out.precision(17);
  const double rate = damping_rate(gas);
  if (gas.oblique)
    out << "pair_style gran/hooke/history " << stiffness << ' ' << 2.0 / 7.0 * stiffness << ' ' << rate << ' '
        << 0.5 * rate << ' ' << friction << " 1\npair_coeff * *\n";
  else
    out << "pair_style gran/hooke " << stiffness << " NULL " << rate << " 0.0 0.0 0\npair_coeff * *\n";
  return out.str();
}

std::string property(const char* name, double value, const char* kind = "peratomtypepair 2") {
  std::ostringstream out;
  out.precision(17);
  out << "fix " << name << " all property/global " << name << ' ' << kind;
  const int values = std::string(kind) == "peratomtype" ? 2 : 4;
  for (int i = 0; i < values; ++i) out << ' ' << value;
  out << '\n';
  return out.str();
}

std::string liggghts_hertz(const PairGas& gas, const Scene& scene) {
  const Elasticity elasticity = *scene.materials[0].elasticity;
  return "pair_style gran model hertz tangential no_history\npair_coeff * *\n" +
         property("youngsModulus", elasticity.youngs_modulus, "peratomtype") +
         property("poissonsRatio", elasticity.poisson_ratio, "peratomtype") +
         property("coefficientRestitution", gas.restitution) + property("coefficientFriction", 0.0);
}

std::string liggghts_style(const PairGas& gas, const Scene& scene) {
  if (gas.hertz) return liggghts_hertz(gas, scene);
  const double rate = damping_rate(gas);
  return std::string("pair_style gran model hooke/stiffness tangential ") +
         (gas.oblique ? "history" : "no_history") + " tangential_damping on\npair_coeff * *\n" +
         property("kn", stiffness) + property("kt", 2.0 / 7.0 * stiffness) + property("gamman", rate) +
         property("gammat", gas.oblique ? 0.5 * rate : 0.0) +
         property("coefficientFriction", gas.oblique ? friction : 0.0);
}

/// Of both programs: γ v on every body, all of one size.
std::string drag_fix() {
  std::ostringstream out;
  out.precision(17);
  out << "fix drag all viscous " << 3.0 * std::numbers::pi * pair_viscosity() * diameter << '\n';
  return out.str();
}

std::string boundaries(const Scene& scene) {
  std::string text = "boundary";
  for (int axis = 0; axis < 3; ++axis) text += scene.domain.periodic(axis) ? " p" : " f";
  return text + "\n" + (scene.walls.empty() ? "" : "processors * * 1\n");
}

/// The velocities are written down after the run that is timed.
std::string deck(PeerProgram program, const std::string& contacts, const Scene& scene, std::int64_t steps) {
  const bool lammps = program == PeerProgram::lammps;
  std::ostringstream out;
  out.precision(17);
  out << (lammps ? "atom_style sphere\n" : "soft_particles yes\nhard_particles yes\natom_style granular\n")
      << "atom_modify map array\n"
      << boundaries(scene) << "newton off\n"
      << (lammps ? "comm_modify vel yes\n" : "communicate single vel yes\n")
      << "units si\nread_data data\nneighbor " << scene.run.skin << " bin\nneigh_modify delay 0\n"
      << contacts << "fix motion all nve" << (scene.rotation ? "/sphere" : "") << "\ntimestep "
      << scene.run.step << "\nthermo 1000000000\nrun " << steps
      << "\ndump last all custom 1 frame id vx vy vz\ndump_modify last first yes "
      << (lammps ? "format line" : "format") << " \"%d %.17g %.17g %.17g\"\nrun 0\n";
  return out.str();
}

std::vector<Vec3> read_velocities(const std::filesystem::path& file, std::size_t particles) {
  std::ifstream in(file);
  std::vector<Vec3> velocity(particles, Vec3::Constant(std::nan("")));
  std::string line;
  while (std::getline(in, line) && !line.starts_with("ITEM: ATOMS")) continue;
  std::size_t id = 0;
  for (Vec3 v; in >> id >> v.x() >> v.y() >> v.z();)
    if (id >= 1 && id <= particles) velocity[id - 1] = v;
  return velocity;
}

/// Of the first run, without what its writing took.
double loop_seconds(const std::filesystem::path& output) {
  std::ifstream in(output);
  double loop = 0.0;
  for (std::string line; std::getline(in, line);)
    if (loop == 0.0) sscanf(line.c_str(), "Loop time of %lf", &loop);
  return loop;
}

}  // namespace

std::string peer_lacks(PeerProgram program, const PairGas& gas) {
  if (gas.cohesive) return "the peers' cohesion is another one";
  if (program == PeerProgram::lammps && gas.hertz)
    return "the dashpot of LAMMPS' gran/hertz is another one, so its restitution depends on speed";
  return {};
}

std::string pair_contacts(PeerProgram program, const PairGas& gas, const Scene& scene) {
  return (program == PeerProgram::lammps ? lammps_style(gas) : liggghts_style(gas, scene)) +
         (gas.drag ? drag_fix() : "");
}

std::vector<double> peer_restitutions(const PairGas& gas, const Scene& scene) {
  std::vector<double> restitutions;
  for (std::size_t pair = 0; 2 * pair < scene.particles.size(); ++pair)
    restitutions.push_back(
        gas.hertz ? gas.restitution : restitution_at(damping_rate(gas), effective_mass_of_pair(scene, pair)));
  return restitutions;
}

PeerRun run_peer(PeerProgram program, const std::string& contacts, const Scene& scene, std::int64_t steps,
                 int processes) {
  const TemporaryFolder folder;
  write_peer_data(scene, folder.path() / "data");
  std::ofstream(folder.path() / "deck") << deck(program, contacts, scene, steps);
  std::vector<std::string> words;
  if (processes > 1)
    words = {"mpirun", "--allow-run-as-root", "--oversubscribe", "-np", std::to_string(processes)};
  for (const char* word :
       {program == PeerProgram::lammps ? "lmp" : "liggghts", "-in", "deck", "-log", "none"})
    words.emplace_back(word);
  const std::filesystem::path output = folder.path() / "output";
  if (run_program(words, folder.path(), output) != 0) throw EngineFailed(last_lines(output, 3));
  return {read_velocities(folder.path() / "frame", scene.particles.size()), loop_seconds(output)};
}

}  // namespace grainproof::bench
