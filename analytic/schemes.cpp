// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/schemes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "model/errors.hpp"

namespace grainproof::analytic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// A linear map of the state at the start of a step; a step is written with these as the scheme is.
using Row = MatrixXd;

/// The parts of a state, each of the system's size, as maps of the state.
struct Parts {
  Index size, count;
  Row operator()(Index which) const {
    Row part = Row::Zero(size, size * count);
    part.middleCols(which * size, size).setIdentity();
    return part;
  }
};

template <class... Rows>
MatrixXd stacked(const Rows&... rows) {
  const std::array<const Row*, sizeof...(Rows)> all{&rows...};
  MatrixXd matrix(all[0]->rows() * static_cast<Index>(all.size()), all[0]->cols());
  Index at = 0;
  for (const Row* row : all) {
    matrix.middleRows(at, row->rows()) = *row;
    at += row->rows();
  }
  return matrix;
}

bool remembers(const LinearSystem& system) {
  return (system.remembered.array() != 0.0).any();
}

/// Position, velocity times step, springs as they were at the force just evaluated. `drag` is what of the
/// drag counts as a force, `slowed` what takes place on the new velocity.
MatrixXd trapezoid_step(const LinearSystem& system, double h, const MatrixXd& drag, const MatrixXd& slowed) {
  const Parts part{system.size(), remembers(system) ? 3 : 2};
  const Row x = part(0), v = part(1);
  Row push = h * h * system.stiffness * x + h * (system.damping + drag) * v;
  if (part.count == 3) push += h * h * system.remembered * part(2);
  const Row new_v = slowed * (v - push);
  const Row new_x = x + 0.5 * (v + new_v);
  // The next force is evaluated with the new velocity, and its springs grow by it (history.1).
  return part.count == 3 ? stacked(new_x, new_v, Row(part(2) + new_v)) : stacked(new_x, new_v);
}

MatrixXd euler_trapezoid(const LinearSystem& system, double h) {
  return trapezoid_step(system, h, system.drag, MatrixXd::Identity(system.size(), system.size()));
}

MatrixXd euler_trapezoid_implicit_drag(const LinearSystem& system, double h) {
  const MatrixXd rest = MatrixXd::Identity(system.size(), system.size()) + h * system.drag;
  return trapezoid_step(system, h, MatrixXd::Zero(system.size(), system.size()), rest.inverse());
}

/// Position and half-step velocity times step. Springs grow by what moves the bodies: they are positions.
MatrixXd verlet(const LinearSystem& system, double h) {
  const Parts part{system.size(), 2};
  const Row x = part(0), half = part(1);
  const Row new_half =
      half - h * h * (system.stiffness + system.remembered) * x - h * (system.damping + system.drag) * half;
  return stacked(Row(x + new_half), new_half);
}

/// Position, half-step velocity times step, acceleration before it times step squared. Springs are positions
/// here too: only dashpots and drag see the predicted velocity.
MatrixXd predicted_verlet(const LinearSystem& system, double h) {
  const Parts part{system.size(), 3};
  const Row x = part(0), half = part(1);
  const Row predicted = half + 0.5 * part(2);
  const Row a =
      -h * h * (system.stiffness + system.remembered) * x - h * (system.damping + system.drag) * predicted;
  return stacked(Row(x + half + a), Row(half + a), a);
}

/// As Verlet, but dashpots take what springs make of the half-step velocity. The system's damping is that of
/// dashpots weakened by what each does to itself; drag does likewise.
MatrixXd implicit_verlet(const LinearSystem& system, double h) {
  const Parts part{system.size(), 2};
  const Row x = part(0), half = part(1);
  const MatrixXd rest = MatrixXd::Identity(system.size(), system.size()) + 0.5 * h * system.drag;
  const Row springs = -h * h * (system.stiffness + system.remembered) * x;
  const Row foreseen = half + 0.5 * springs;
  const Row new_half = half + springs - h * (system.damping + rest.inverse() * system.drag) * foreseen;
  return stacked(Row(x + new_half), new_half);
}

/// Position and velocity times step at a boundary. Springs grow by what moves the bodies.
MatrixXd pefrl(const LinearSystem& system, double h) {
  constexpr double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;
  constexpr std::array drifts{xi, chi, 1.0 - 2.0 * (chi + xi), chi};
  constexpr std::array kicks{0.5 - lambda, lambda, lambda, 0.5 - lambda};
  const Parts part{system.size(), 2};
  Row x = part(0), v = part(1);
  for (std::size_t n = 0; n < kicks.size(); ++n) {
    x += drifts[n] * v;
    v -= kicks[n] *
         (h * h * (system.stiffness + system.remembered) * x + h * (system.damping + system.drag) * v);
  }
  return stacked(Row(x + xi * v), v);
}

double over(double numerator, double denominator) {
  return denominator > 0.0 ? numerator / denominator : std::numeric_limits<double>::infinity();
}

constexpr std::array schemes{
    LinearScheme{"euler_trapezoid", euler_trapezoid, {0.0, 1.0, 2.0, 1.0}, true},
    LinearScheme{"euler_trapezoid_implicit_drag", euler_trapezoid_implicit_drag, {0.0, 1.0, 2.0, -1.0}, true},
    LinearScheme{"leapfrog_verlet", verlet, {1.0, 1.0, 2.0, 1.0}},
    LinearScheme{"velocity_verlet", verlet, {1.0, 1.0, 2.0, 1.0}},
    LinearScheme{"velocity_verlet_predicted", predicted_verlet, {1.0, 1.0, 4.0, 1.0}},
    // The same while no contact begins or ends, but for weaker dashpots, which only widens the first limit.
    LinearScheme{.name = "onset_corrected",
                 .step = predicted_verlet,
                 .flip = {1.0, 1.0, 4.0, 1.0},
                 .weakens = Weakening::by_spring},
    // A bound: springs and dashpots have a limit each, of which the second is weaker than this.
    LinearScheme{.name = "velocity_verlet_implicit",
                 .step = implicit_verlet,
                 .flip = {1.0, 1.0, 2.0, 1.0},
                 .weakens = Weakening::by_itself},
    // A bound, found: springs alone allow k h² < 8.94 m, dashpots alone η h < 2.34 m.
    LinearScheme{.name = "pefrl", .step = pefrl, .flip = {0.5, 0.5, 2.0, 1.0}, .composed = true},
};

}  // namespace

std::span<const LinearScheme> linear_schemes() {
  return schemes;
}

double flip_limit(const LinearScheme& scheme, const LinearContact& contact) {
  const FlipCondition& flip = scheme.flip;
  const double k = flip.stiffness * contact.stiffness + flip.remembered * contact.remembered;
  const double c = 0.5 * flip.damping * (contact.damping + flip.drag * contact.mass * contact.drag_rate);
  if (k == 0.0) return over(2.0 * contact.mass, c);
  return over(4.0 * contact.mass, c + std::sqrt(c * c + 4.0 * k * contact.mass));
}

namespace {

/// One body, one contact: (stability.12).
double implicit_limit(const LinearContact& contact) {
  const double springs = over(contact.mass, contact.stiffness + contact.remembered);
  const double dashpots = over(contact.mass, contact.damping * contact.drag_rate);
  return 2.0 * std::sqrt(std::min(springs, dashpots));
}

constexpr double round_off = 1e-12;

/// Where the first instability begins; there may be stable steps beyond it.
double searched_first_unstable_step(const LinearScheme& scheme, const LinearContact& contact) {
  const auto number = [](double value) { return MatrixXd::Constant(1, 1, value); };
  const LinearSystem system{number(contact.stiffness / contact.mass),
                            number(contact.remembered / contact.mass), number(contact.damping / contact.mass),
                            number(contact.drag_rate)};
  const auto stable = [&](double h) {  // (integrators.5)
    const MatrixXd m = scheme.step(system, h);
    const double trace = m(0, 0) + m(1, 1), determinant = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
    return determinant <= 1.0 + round_off && std::abs(trace) <= 1.0 + determinant + round_off;
  };
  double low = 0.5 * flip_limit(scheme, contact);
  if (!(low > 0.0) || std::isinf(low)) return low;
  while (stable(1.05 * low)) low *= 1.05;
  double high = 1.05 * low;
  while (high - low > 1e-6 * high) (stable(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return low;
}

/// Kept, since the scenes of a sweep mostly have the same contacts and a search takes as long as reading one.
double first_unstable_step(const LinearScheme& scheme, const LinearContact& contact) {
  constexpr std::size_t most_kept = 256;
  thread_local std::map<std::pair<std::string_view, LinearContact>, double> kept;
  const auto found = kept.find({scheme.name, contact});
  if (found != kept.end()) return found->second;
  if (kept.size() >= most_kept) kept.clear();
  return kept[{scheme.name, contact}] = searched_first_unstable_step(scheme, contact);
}

}  // namespace

double pair_limit(const LinearScheme& scheme, const LinearContact& contact) {
  if (scheme.weakens == Weakening::by_itself) return implicit_limit(contact);
  if (scheme.composed) return first_unstable_step(scheme, contact);
  double limit = flip_limit(scheme, contact);
  if (scheme.gains)
    limit =
        std::min(limit, over(2.0 * (contact.damping + contact.mass * contact.drag_rate), contact.stiffness));
  return limit;
}

const LinearScheme& linear_scheme(std::string_view name) {
  const auto found = std::ranges::find(schemes, name, &LinearScheme::name);
  if (found == schemes.end())
    throw InputRefused("found integrator " + std::string(name) + "; expected one whose stability is known");
  return *found;
}

}  // namespace grainproof::analytic
