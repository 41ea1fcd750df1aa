// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "benchmarks/common/stability_cases.hpp"
#include "input/uniform.hpp"
#include "model/errors.hpp"

/// Static equilibrium of spheres pressed together: a minimum of their elastic energy.
namespace grainproof::bench {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int bodies = 24;
constexpr double diameter = 0.1;  // m, the mean one
constexpr double spread = 0.1;    // of it, so that nothing crystallises
constexpr double loosest = 0.62;  // share of the volume that spheres fill
constexpr double densest = 0.95;
constexpr double denser = 1.01;       // a stage over the one before
constexpr double least_clear = 1e-5;  // of a diameter: no contact is about to open or to close
constexpr double residual = 1e-13;    // of a force, k d
constexpr int most_iterations = 2000;

struct Landscape {
  double energy = 0.0;
  VectorXd gradient;
  MatrixXd hessian;
};

double stiffness_between(const Scene& scene, std::size_t i, std::size_t j) {
  const auto& laws = scene.contacts.at(scene.particles[i].material, scene.particles[j].material);
  return std::get<LinearNormal>(laws.normal).stiffness;
}

Landscape landscape(const Scene& scene) {
  const auto size = static_cast<Index>(3 * scene.particles.size());
  Landscape here{0.0, VectorXd::Zero(size), MatrixXd::Zero(size, size)};
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 between = apart(scene, i, j);
      const double distance = between.norm();
      const double overlap = 0.5 * (scene.particles[i].diameter + scene.particles[j].diameter) - distance;
      if (overlap <= 0.0) continue;
      const double k = stiffness_between(scene, i, j);
      const Vec3 n = between / distance;
      const Eigen::Matrix3d block =
          k * n * n.transpose() - k * overlap / distance * (Eigen::Matrix3d::Identity() - n * n.transpose());
      const auto a = static_cast<Index>(3 * i), b = static_cast<Index>(3 * j);
      here.energy += 0.5 * k * overlap * overlap;
      here.gradient.segment<3>(a) += k * overlap * n;
      here.gradient.segment<3>(b) -= k * overlap * n;
      here.hessian.block<3, 3>(a, a) += block;
      here.hessian.block<3, 3>(b, b) += block;
      here.hessian.block<3, 3>(a, b) -= block;
      here.hessian.block<3, 3>(b, a) -= block;
    }
  return here;
}

void move(Scene& scene, const VectorXd& by) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    Vec3& place = scene.particles[i].position;
    place += by.segment<3>(static_cast<Index>(3 * i));
    for (int axis = 0; axis < 3; ++axis)
      place[axis] -= scene.domain.extent()[axis] * std::floor(place[axis] / scene.domain.extent()[axis]);
  }
}

/// Levenberg and Marquardt. False where no minimum was reached.
bool relax(Scene& scene) {
  const double force = stiffness_between(scene, 0, 0) * diameter;
  double caution = 1e-2 * stiffness_between(scene, 0, 0);
  Landscape here = landscape(scene);
  for (int n = 0; n < most_iterations; ++n) {
    if (here.gradient.lpNorm<Eigen::Infinity>() < residual * force) return true;
    const MatrixXd slope =
        here.hessian + caution * MatrixXd::Identity(here.hessian.rows(), here.hessian.cols());
    const Eigen::LDLT<MatrixXd> solver(slope);
    if (solver.isPositive()) {
      Scene moved = scene;
      move(moved, -solver.solve(here.gradient));
      Landscape there = landscape(moved);
      if (there.energy <= here.energy) {
        scene = std::move(moved);
        here = std::move(there);
        caution = std::max(0.3 * caution, 1e-9 * stiffness_between(scene, 0, 0));
        continue;
      }
    }
    caution *= 4.0;
    if (caution > 1e12) return here.gradient.lpNorm<Eigen::Infinity>() < 1e3 * residual * force;
  }
  return false;
}

void set_box(Scene& scene, double filled) {
  double volume = 0.0;
  for (const Particle& particle : scene.particles)
    volume += std::numbers::pi / 6.0 * std::pow(particle.diameter, 3);
  const Vec3 before = scene.domain.upper;
  scene.domain.upper = Vec3::Constant(std::cbrt(volume / filled));
  for (Particle& particle : scene.particles)
    particle.position = particle.position.cwiseQuotient(before).cwiseProduct(scene.domain.upper);
}

void scatter(Scene& scene, std::int64_t seed) {
  input::Uniform uniform(seed);
  scene.particles.clear();
  for (int i = 0; i < bodies; ++i) {
    const double size = diameter * (1.0 + spread * (2.0 * uniform() - 1.0));
    const Vec3 place = 0.5 * (uniform.in_cube() + Vec3::Ones());
    scene.particles.push_back(
        {i + 1, i % 2, false, size, size, place.cwiseProduct(scene.domain.upper), Vec3::Zero()});
  }
}

bool each_is_held(const Scene& scene) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    int contacts = 0;
    for (std::size_t j = 0; j < scene.particles.size(); ++j)
      if (i != j &&
          apart(scene, i, j).norm() < 0.5 * (scene.particles[i].diameter + scene.particles[j].diameter))
        ++contacts;
    if (contacts < 4) return false;
  }
  return true;
}

/// Presses one sample on; false where it does not come to what is wanted.
bool press(Scene& scene, int contacts) {
  for (double filled = loosest; filled < densest; filled *= denser) {
    set_box(scene, filled);
    if (!relax(scene)) return false;
    const int most = most_contacts(scene);
    if (most > contacts) return false;
    if (most == contacts && each_is_held(scene) && least_slack(scene) > least_clear * diameter) return true;
  }
  return false;
}

}  // namespace

void fill_packing(Scene& scene, int contacts) {
  for (std::int64_t seed = 1; seed <= 200; ++seed) {
    scatter(scene, seed);
    if (press(scene, contacts)) return;
  }
  throw InputRefused("found no packing with " + std::to_string(contacts) + " contacts; expected 8 to 12");
}

}  // namespace grainproof::bench
