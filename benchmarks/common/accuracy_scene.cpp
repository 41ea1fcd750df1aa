// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/accuracy_scene.hpp"

#include <cmath>
#include <numbers>

#include "benchmarks/common/scenes.hpp"
#include "input/uniform.hpp"
#include "model/engine.hpp"

namespace grainproof::bench {
namespace {

constexpr double pair_mass = 0.5 * density * std::numbers::pi / 6.0 * diameter * diameter * diameter;

/// Of the usual spheres, with the usual laws.
double usual_contact() {
  const double logarithm = std::log(restitution);
  return std::sqrt((std::pow(std::numbers::pi, 2) + logarithm * logarithm) * pair_mass / stiffness);
}

void end_after(Scene& scene, double contacts, double steps_per_contact) {
  scene.run.step = usual_contact() / steps_per_contact;
  scene.run.end = contacts * usual_contact();
  scene.run.sample_times = {0.0, scene.run.end};
}

/// A cube of spheres a little apart, each at its own distance, and each kicked: no two contacts begin at the
/// same phase of a step.
Scene packing(std::int64_t side, double contacts, double steps_per_contact) {
  constexpr double spacing = 1.004 * diameter, shift = 0.001 * diameter, kick = 0.3, margin = 3.0 * diameter;
  Scene scene = empty_scene(Vec3::Constant(static_cast<double>(side) * spacing + 2.0 * margin));
  scene.domain.boundary = {Boundary::open, Boundary::open, Boundary::open};
  input::Uniform uniform(3);
  for (std::int64_t n = 0; n < side * side * side; ++n) {
    const Vec3 cell(static_cast<double>(n % side), static_cast<double>(n / side % side),
                    static_cast<double>(n / (side * side)));
    scene.particles.push_back(
        {n + 1, 0, false, diameter, diameter,
         Vec3::Constant(margin) + spacing * (cell + Vec3::Constant(0.5)) + shift * uniform.in_cube(),
         kick * uniform.in_cube()});
  }
  end_after(scene, contacts, steps_per_contact);
  return scene;
}

}  // namespace

std::vector<AccuracyScene> accuracy_scenes(bool quick, const std::filesystem::path& cache) {
  const std::vector<double> few{8, 32, 128}, all{8, 16, 32, 64, 128, 256, 512};
  const std::vector<double> few_timed{8, 32, 128, 256};  // the field's scheme is within 1e-3 at the last
  const auto steps = [&](const PairGas& gas) {
    if (!quick) return all;
    return gas.name == "pair_gas" ? few_timed : few;
  };
  std::vector<AccuracyScene> scenes;
  for (const PairGas& gas : pair_gases(quick))
    scenes.push_back({gas.name, [gas](double ratio) { return pair_scene(gas, ratio); }, steps(gas), gas});
  const std::vector<double> many = quick ? std::vector<double>{16, 32} : std::vector<double>{16, 32, 64, 128};
  const double contacts = quick ? 2.0 : 4.0;
  const auto add = [&](const char* name, std::function<Scene()> make) {
    scenes.push_back({name,
                      [make = std::move(make), contacts](double ratio) {
                        Scene scene = make();
                        end_after(scene, contacts, ratio);
                        return scene;
                      },
                      many});
  };
  add("packing", [side = quick ? 6 : 10] { return packing(side, 1.0, 1.0); });
  add("gas", [size = quick ? 200 : 1000] { return gas(size); });
  add("bed", [cache] { return bed(900, cache); });
  return scenes;
}

std::int64_t steps_of(const Scene& scene) {
  return step_at_or_after(scene.run.end, scene.run.step);
}

std::vector<Vec3> compared(const AccuracyScene& scene, const std::vector<Vec3>& velocity) {
  return scene.gas ? relative_velocities(velocity) : velocity;
}

std::vector<Vec3> velocities_of(const Scene& scene) {
  std::vector<Vec3> velocity;
  for (const Particle& particle : scene.particles) velocity.push_back(particle.velocity);
  return velocity;
}

double scene_error(const AccuracyScene& scene, const std::vector<Vec3>& found, const std::vector<Vec3>& exact,
                   const std::vector<Vec3>& start) {
  if (scene.gas) return rms_error(found, exact, start);
  double difference = 0.0, before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    difference += (found[i] - exact[i]).squaredNorm();
    before += start[i].squaredNorm();
    after += exact[i].squaredNorm();
  }
  return std::sqrt(difference / (before > 0.0 ? before : after));
}

}  // namespace grainproof::bench
