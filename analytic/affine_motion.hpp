// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>

namespace grainproof::analytic {

/// y' = A y + b with constant A and b, of any size. Times count from the motion's own start.
class AffineMotion {
 public:
  AffineMotion(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& constant, const Eigen::VectorXd& start);

  /// Exact up to the rounding of a matrix exponential: about 1e-16 times the largest rate times `time`.
  Eigen::VectorXd at(double time) const;

 private:
  Eigen::MatrixXd generator_;  ///< of (y, 1), in balanced units
  Eigen::VectorXd start_, units_;
};

}  // namespace grainproof::analytic
