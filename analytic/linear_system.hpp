// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "model/scene.hpp"

/// Small motions about a state in which every contact is kept and sticks: docs/stability.md.
namespace grainproof::analytic {

/// In coordinates y that are weighted with the root of their masses,
///     y'' = −K y − H s − (C + D) y',
/// where s is y as the springs of history.1 remember it: the sum of the velocities that forces were given.
struct LinearSystem {
  Eigen::MatrixXd stiffness;   ///< K, 1/s²
  Eigen::MatrixXd remembered;  ///< H, 1/s²
  Eigen::MatrixXd damping;     ///< C, 1/s
  Eigen::MatrixXd drag;        ///< D, 1/s

  Eigen::Index size() const { return stiffness.rows(); }
};

/// From masses (kg, kg m²) and matrices in N/m and N s/m; no springs that remember, no drag.
LinearSystem mass_weighted(const Eigen::VectorXd& mass, const Eigen::MatrixXd& stiffness,
                           const Eigen::MatrixXd& damping);

/// The system in the coordinates z of y = basis z; the basis is orthonormal.
LinearSystem projected(const LinearSystem& system, const Eigen::MatrixXd& basis);

/// Without the motions that no force knows (a drift of everything, shear without friction): they neither grow
/// nor decay, and a double root at 1 would blur the others.
LinearSystem without_free_motions(const LinearSystem& system);

/// Whether the force between bodies that are pressed together turns with them: −f/r across their line.
enum class Prestress { kept, left_out };

/// How a scheme weakens the dashpot of a contact: not at all, as onset_corrected by what its spring will do
/// (stability.9), or as velocity_verlet_implicit by what it does itself (stability.12).
enum class Weakening { none, by_spring, by_itself };

/// What depends on the step, s: how far a dashpot is weakened, and friction that holds the step itself
/// (friction.2).
struct StepOf {
  Weakening weakening = Weakening::none;
  double step = 0.0;
};

/// Every contact of the scene as it is at the start, moving bodies only: three coordinates each, or six with
/// rotation. Linear contacts, cohesion, tangential springs, drag; planes as walls. Throws InputRefused for
/// other laws and walls. Friction without memory is taken in its static branch.
LinearSystem linearised(const Scene& scene, Prestress prestress, const StepOf& step = {});

/// The same in pieces, one for each way in which half the box along a periodic axis may map the system onto
/// itself, changed in sign or not. One piece where there is no such axis.
std::vector<LinearSystem> symmetric_parts(const Scene& scene, const LinearSystem& system);

}  // namespace grainproof::analytic
