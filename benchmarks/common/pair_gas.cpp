// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/pair_gas.hpp"

#include <cmath>
#include <numbers>

#include "benchmarks/common/scenes.hpp"
#include "input/uniform.hpp"

namespace grainproof::bench {
namespace {

constexpr double spacing = 8.0 * diameter;      // of pairs, which never meet one another
constexpr double hertz_youngs_modulus = 4.0e7;  // Pa: contacts that last as long as the linear ones
constexpr double hertz_poisson_ratio = 0.3;
constexpr double effect = 1.02;              // effect diameters over diameters
constexpr double cohesion_stiffness = 50.0;  // N/m: takes up to an eighth of the slowest pair's energy
constexpr double relaxation_contacts = 4.0;  // contacts that drag's relaxation time lasts

double sphere_mass(double of_diameter) {
  return density * std::numbers::pi / 6.0 * std::pow(of_diameter, 3);
}

Vec3 random_direction(input::Uniform& uniform) {
  for (;;) {
    const Vec3 direction = uniform.in_cube();
    const double length = direction.norm();
    if (length > 0.1 && length < 1.0) return direction / length;
  }
}

ContactLaws laws_of(const PairGas& gas) {
  ContactLaws laws;
  if (gas.hertz)
    laws.normal = HertzNormal{Restitution{gas.restitution}};
  else
    laws.normal = LinearNormal{stiffness, Restitution{gas.restitution}};
  if (gas.cohesive) laws.cohesion = LinearCohesion{cohesion_stiffness};
  if (gas.oblique) laws.friction = HistoryFriction{friction, 2.0 / 7.0 * stiffness, 0.5};
  return laws;
}

/// Time scale that steps are counted in.
double counted_contact(const PairGas& gas) {
  return contact_time(0.5 * sphere_mass(gas.counted_in * diameter), gas.restitution);
}

/// Contacts of that kind until the last pair has parted, effect surfaces included.
std::int64_t contacts_to_part(const PairGas& gas) {
  return gas.cohesive ? 4 : 2;
}

/// The two bodies of a pair about `centre`, to touch after the time `until`.
void add_pair(Scene& scene, const PairGas& gas, const Vec3& centre, double until, input::Uniform& uniform) {
  const Vec3 normal = random_direction(uniform);
  const double speed = 0.5 + uniform();
  const auto random_diameter = [&] {
    return gas.spread == 0.0 ? diameter : diameter * (1.0 + gas.spread * (2.0 * uniform() - 1.0));
  };
  const double reach = gas.cohesive ? effect : 1.0;
  const double one = random_diameter(), two = random_diameter();
  const Vec3 apart = (0.5 * reach * (one + two) + speed * until) * normal;
  Vec3 velocity = -speed * normal;
  if (gas.oblique) velocity += (2.0 * uniform() * speed) * normal.cross(random_direction(uniform));
  const Vec3 drift = gas.oblique ? Vec3(velocity + speed * normal) : Vec3(Vec3::Zero());
  const auto id = static_cast<std::int64_t>(scene.particles.size()) + 1;
  scene.particles.push_back(
      {id, 0, false, one, reach * one, centre - 0.5 * apart + 0.5 * until * drift, -0.5 * velocity});
  scene.particles.push_back(
      {id + 1, 0, false, two, reach * two, centre + 0.5 * apart - 0.5 * until * drift, 0.5 * velocity});
}

}  // namespace

std::vector<PairGas> pair_gases(bool quick) {
  const std::int64_t few = quick ? 100 : 500, many = quick ? 1000 : 10000;
  // Where all are alike the ratio of contact to step is never a whole number.
  return {{"head_on", few, 0.8},
          {"elastic", few, 1.0},
          {"hertz", few, 0.8, true},
          {.name = "oblique",
           .pairs = few,
           .restitution = 0.8,
           .oblique = true,
           .spread = 0.0,
           .counted_in = 1.03},
          {.name = "cohesive", .pairs = few, .restitution = 0.8, .cohesive = true},
          {.name = "drag", .pairs = few, .restitution = 0.8, .drag = true, .spread = 0.0, .counted_in = 1.03},
          {"pair_gas", many, 0.8}};
}

double pair_viscosity() {
  const double relaxation = relaxation_contacts * contact_time(0.5 * sphere_mass(diameter), 1.0);
  return density * diameter * diameter / (18.0 * relaxation);
}

double contact_time(double effective_mass, double of_restitution) {
  const double logarithm = std::log(of_restitution);
  return std::sqrt((std::pow(std::numbers::pi, 2) + logarithm * logarithm) * effective_mass / stiffness);
}

Scene pair_scene(const PairGas& gas, double steps_per_contact) {
  const auto side = static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(gas.pairs)) - 1e-9));
  Scene scene = empty_scene(Vec3::Constant(static_cast<double>(side) * spacing));
  scene.domain.boundary = {Boundary::open, Boundary::open, Boundary::open};
  if (gas.hertz) scene.materials[0].elasticity = Elasticity{hertz_youngs_modulus, hertz_poisson_ratio};
  scene.contacts.set(0, 0, laws_of(gas));
  scene.rotation = gas.oblique;
  if (gas.drag) scene.flow = UniformFlow{pair_viscosity(), Vec3::Zero()};
  scene.run.step = counted_contact(gas) / steps_per_contact;
  scene.run.skin = diameter;
  input::Uniform uniform(7);
  for (std::int64_t pair = 0; pair < gas.pairs; ++pair) {
    const Vec3 cell(static_cast<double>(pair % side), static_cast<double>(pair / side % side),
                    static_cast<double>(pair / (side * side)));
    const double until = counted_contact(gas) * (0.2 + 0.3 * uniform());
    add_pair(scene, gas, spacing * (cell + Vec3::Constant(0.5)), until, uniform);
  }
  scene.run.end = static_cast<double>(contacts_to_part(gas)) * counted_contact(gas);
  scene.run.sample_times = {0.0, scene.run.end};
  return scene;
}

std::vector<Vec3> relative_velocities(const std::vector<Vec3>& velocity) {
  std::vector<Vec3> relative;
  for (std::size_t i = 0; i + 1 < velocity.size(); i += 2) relative.push_back(velocity[i + 1] - velocity[i]);
  return relative;
}

double effective_mass_of_pair(const Scene& scene, std::size_t pair) {
  const double one = sphere_mass(scene.particles[2 * pair].diameter);
  const double two = sphere_mass(scene.particles[2 * pair + 1].diameter);
  return one * two / (one + two);
}

std::vector<Vec3> rebounds(const Scene& scene, const std::vector<double>& of_pair) {
  std::vector<Vec3> exact;
  for (std::size_t pair = 0; pair < of_pair.size(); ++pair)
    exact.push_back(of_pair[pair] *
                    (scene.particles[2 * pair].velocity - scene.particles[2 * pair + 1].velocity));
  return exact;
}

double rms_error(const std::vector<Vec3>& found, const std::vector<Vec3>& exact,
                 const std::vector<Vec3>& start) {
  double sum = 0.0;
  for (std::size_t pair = 0; pair < exact.size(); ++pair)
    sum += (found[pair] - exact[pair]).squaredNorm() / start[pair].squaredNorm();
  return std::sqrt(sum / static_cast<double>(exact.size()));
}

}  // namespace grainproof::bench
