// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

#include "analytic/contact_scales.hpp"
#include "analytic/hertz.hpp"
#include "analytic/solution.hpp"

/// A dilute gas of smooth, equal spheres that cools by its collisions alone (Haff 1983): gas.1 to gas.3.
/// It is a law of the mean: it says how fast the gas is, not where anything is.
namespace grainproof::analytic {
namespace {

constexpr double pi = boost::math::constants::pi<double>();
constexpr double densest = 0.2;  // volume fraction up to which gas.2 counts collisions well
constexpr std::size_t fewest = 100;

double restitution(const NormalLaw& law, double mass) {
  if (const auto* hertz = std::get_if<HertzNormal>(&law)) {
    const double beta = hertz_damping_ratio(hertz->dissipation);
    return beta < 1.0 ? std::exp(-pi * beta / std::sqrt((1.0 - beta) * (1.0 + beta))) : 0.0;
  }
  const auto& linear = std::get<LinearNormal>(law);
  const double eta = damping(linear, mass);
  return linear.no_tension ? no_tension_restitution_of(eta, linear.stiffness, mass)
                           : restitution_of(eta, linear.stiffness, mass);
}

std::string why_not(const Scene& scene) {
  if (scene.particles.size() < fewest) return "there are fewer than 100 particles";
  if (!scene.walls.empty()) return "there are walls";
  for (int axis = 0; axis < 3; ++axis)
    if (!scene.domain.periodic(axis)) return "the domain is not periodic all round";
  if (!std::holds_alternative<NoFlow>(scene.flow)) return "a fluid acts on the particles";
  const auto* gravity = std::get_if<ConstantGravity>(&scene.gravity);
  if (!gravity || !gravity->acceleration.isZero(0.0)) return "gravity acts";
  if (scene.rotation) return "the bodies turn";
  const Particle& one = scene.particles.front();
  for (const Particle& particle : scene.particles)
    if (particle.fixed || particle.diameter != one.diameter || particle.material != one.material)
      return "the particles are not all alike and free";
  const ContactLaws& laws = scene.contacts.at(one.material, one.material);
  if (!std::holds_alternative<NoCohesion>(laws.cohesion)) return "cohesion acts";
  return std::holds_alternative<Frictionless>(laws.friction) ? "" : "there is friction";
}

struct Gas {
  Vec3 drift = Vec3::Zero();
  double rate = 0.0;  ///< 1/τ of gas.1, 1/s
};

Gas gas_of(const Scene& scene, double fraction) {
  const Particle& one = scene.particles.front();
  const auto count = static_cast<double>(scene.particles.size());
  Gas gas;
  for (const Particle& particle : scene.particles) gas.drift += particle.velocity / count;
  double temperature = 0.0;  // <u²>/3, m²/s²
  for (const Particle& particle : scene.particles)
    temperature += (particle.velocity - gas.drift).squaredNorm() / (3.0 * count);
  const double mass = 0.5 * sphere_mass(scene.materials[one.material].density, one.diameter);
  const double e = restitution(scene.contacts.at(one.material, one.material).normal, mass);
  const double crowding = (1.0 - 0.5 * fraction) / std::pow(1.0 - fraction, 3);
  const double collisions = 4.0 * std::sqrt(pi * temperature) * count / scene.domain.extent().prod() *
                            one.diameter * one.diameter * crowding;
  gas.rate = (1.0 - e * e) / 6.0 * collisions;
  return gas;
}

}  // namespace

Solution haff(const Scene& scene, double) {
  if (const std::string because = why_not(scene); !because.empty()) return Solution::no(because);
  const double fraction = static_cast<double>(scene.particles.size()) * pi / 6.0 *
                          std::pow(scene.particles.front().diameter, 3) / scene.domain.extent().prod();
  if (fraction > densest) return Solution::no("the gas is denser than a fifth of the volume");
  const Gas gas = gas_of(scene, fraction);
  Solution solution;
  solution.frame_at = [scene, gas](double time) {
    Frame frame = empty_frame(scene, time);
    for (const Particle& particle : scene.particles) {
      frame.position.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      frame.velocity.push_back(gas.drift + (particle.velocity - gas.drift) / (1.0 + gas.rate * time));
    }
    return frame;
  };
  solution.scalars["cooling_time"] = 1.0 / gas.rate;
  return solution;
}

}  // namespace grainproof::analytic
