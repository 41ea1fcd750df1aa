// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <optional>

#include "analytic/linear_system.hpp"

namespace grainproof::analytic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

using Permutation = std::vector<std::size_t>;

/// Of a diameter: what two places may differ by to be the same one.
constexpr double same_place = 1e-9;

bool is_image(const Scene& scene, const Particle& one, const Particle& other, int axis) {
  Vec3 apart = other.position - one.position;
  apart[axis] -= 0.5 * scene.domain.extent()[axis];
  for (int i = 0; i < 3; ++i)
    if (scene.domain.periodic(i))
      apart[i] -= scene.domain.extent()[i] * std::round(apart[i] / scene.domain.extent()[i]);
  return apart.norm() < same_place * one.diameter && one.material == other.material &&
         one.diameter == other.diameter && one.effect_diameter == other.effect_diameter;
}

/// Where each particle goes when everything moves by half the box; none where it then looks different.
std::optional<Permutation> half_box(const Scene& scene, int axis) {
  if (!scene.domain.periodic(axis)) return std::nullopt;
  Permutation to;
  for (const Particle& one : scene.particles) {
    if (one.fixed) return std::nullopt;
    const auto image = std::ranges::find_if(
        scene.particles, [&](const Particle& other) { return is_image(scene, one, other, axis); });
    if (image == scene.particles.end()) return std::nullopt;
    to.push_back(static_cast<std::size_t>(image - scene.particles.begin()));
  }
  return to;
}

/// Motions in which the bodies of every orbit move alike, with the signs of one character of the group.
SparseMatrix basis_of(const std::vector<Permutation>& moves, unsigned character, std::size_t particles,
                      Index coordinates) {
  const std::size_t members = std::size_t{1} << moves.size();
  const double size = 1.0 / std::sqrt(static_cast<double>(members));
  SparseMatrix basis(static_cast<Index>(particles) * coordinates,
                     static_cast<Index>(particles / members) * coordinates);
  std::vector<bool> seen(particles, false);
  Index column = 0;
  for (std::size_t start = 0; start < particles; ++start) {
    if (seen[start]) continue;
    for (std::size_t member = 0; member < members; ++member) {
      std::size_t body = start;
      double sign = size;
      for (std::size_t move = 0; move < moves.size(); ++move) {
        if (!(member >> move & 1U)) continue;
        body = moves[move][body];
        if (character >> move & 1U) sign = -sign;
      }
      seen[body] = true;
      for (Index i = 0; i < coordinates; ++i)
        basis.insert(static_cast<Index>(body) * coordinates + i, column + i) = sign;
    }
    column += coordinates;
  }
  return basis;
}

LinearSystem in_basis(const LinearSystem& system, const SparseMatrix& basis) {
  const SparseMatrix across = basis.transpose();
  const auto of = [&](const MatrixXd& matrix) -> MatrixXd { return across * MatrixXd(matrix * basis); };
  return {of(system.stiffness), of(system.remembered), of(system.damping), of(system.drag)};
}

}  // namespace

std::vector<LinearSystem> symmetric_parts(const Scene& scene, const LinearSystem& system) {
  std::vector<Permutation> moves;
  for (int axis = 0; axis < 3; ++axis)
    if (auto move = half_box(scene, axis)) moves.push_back(std::move(*move));
  std::vector<LinearSystem> parts;
  for (unsigned character = 0; character < 1U << moves.size(); ++character)
    parts.push_back(
        in_basis(system, basis_of(moves, character, scene.particles.size(), scene.rotation ? 6 : 3)));
  return parts;
}

}  // namespace grainproof::analytic
