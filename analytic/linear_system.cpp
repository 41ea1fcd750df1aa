// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/linear_system.hpp"

#include <algorithm>

namespace grainproof::analytic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the largest share in the sum below: round-off leaves 1e-15, a mass ratio of 1e6 leaves 1e-7.
constexpr double free_share = 1e-12;

MatrixXd scaled(const MatrixXd& matrix) {
  const double size = matrix.norm();
  return size == 0.0 ? matrix : MatrixXd(matrix / size);
}

}  // namespace

LinearSystem mass_weighted(const VectorXd& mass, const MatrixXd& stiffness, const MatrixXd& damping) {
  const VectorXd weight = mass.cwiseSqrt().cwiseInverse();
  const MatrixXd none = MatrixXd::Zero(mass.size(), mass.size());
  return {weight.asDiagonal() * stiffness * weight.asDiagonal(), none,
          weight.asDiagonal() * damping * weight.asDiagonal(), none};
}

LinearSystem projected(const LinearSystem& system, const MatrixXd& basis) {
  const auto in_basis = [&](const MatrixXd& matrix) -> MatrixXd {
    return basis.transpose() * matrix * basis;
  };
  return {in_basis(system.stiffness), in_basis(system.remembered), in_basis(system.damping),
          in_basis(system.drag)};
}

LinearSystem without_free_motions(const LinearSystem& system) {
  const MatrixXd forces =
      scaled(system.stiffness) + scaled(system.remembered) + scaled(system.damping) + scaled(system.drag);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> motions(forces);
  const VectorXd share = motions.eigenvalues().cwiseAbs();
  const Index free = std::count_if(share.begin(), share.end(),
                                   [&](double one) { return one <= free_share * share.maxCoeff(); });
  if (free == 0) return system;
  MatrixXd bound(system.size(), system.size() - free);
  for (Index i = 0, column = 0; i < system.size(); ++i)
    if (share[i] > free_share * share.maxCoeff()) bound.col(column++) = motions.eigenvectors().col(i);
  return projected(system, bound);
}

}  // namespace grainproof::analytic
