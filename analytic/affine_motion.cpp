// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/affine_motion.hpp"

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

namespace grainproof::analytic {
namespace {

/// Units of the states in which the rows and columns are alike in size (Osborne 1960): metres beside
/// metres a second would cost the exponential as many digits as the rates have. Powers of two, so that
/// nothing is rounded.
Eigen::VectorXd balance(const Eigen::MatrixXd& matrix) {
  Eigen::MatrixXd balanced = matrix.cwiseAbs();
  balanced.diagonal().setZero();
  Eigen::VectorXd units = Eigen::VectorXd::Ones(matrix.rows());
  for (int sweep = 0; sweep < 20; ++sweep)
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const double row = balanced.row(i).sum(), column = balanced.col(i).sum();
      if (row == 0.0 || column == 0.0) continue;
      const double unit = std::exp2(std::round(0.5 * std::log2(row / column)));
      balanced.row(i) /= unit;
      balanced.col(i) *= unit;
      units[i] *= unit;
    }
  return units;
}

}  // namespace

AffineMotion::AffineMotion(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& constant,
                           const Eigen::VectorXd& start)
    : generator_(Eigen::MatrixXd::Zero(start.size() + 1, start.size() + 1)), start_(start.size() + 1) {
  generator_.topLeftCorner(start.size(), start.size()) = matrix;
  generator_.topRightCorner(start.size(), 1) = constant;
  start_ << start, 1.0;
  units_ = balance(generator_);
  generator_ = units_.cwiseInverse().asDiagonal() * generator_ * units_.asDiagonal();
  start_ = start_.cwiseQuotient(units_);
}

Eigen::VectorXd AffineMotion::at(double time) const {
  const Eigen::MatrixXd flow = (generator_ * time).exp();
  const Eigen::VectorXd now = (flow * start_).cwiseProduct(units_);
  return now.head(start_.size() - 1);
}

}  // namespace grainproof::analytic
