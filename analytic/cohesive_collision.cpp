// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "analytic/contact_scales.hpp"
#include "analytic/dimensionless.hpp"
#include "analytic/passage_solution.hpp"

/// Head-on collision with linear cohesion, without gravity: cohesion.3 to cohesion.7; E1 to E6.
namespace grainproof::analytic {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// Speed that just climbs from body contact to the edge of the attraction (cohesion.5).
double escape_speed(const Encounter& e) {
  return e.reach * std::sqrt(e.cohesion_stiffness() / e.mass);
}

/// Return speed less escape speed for a far speed (cohesion.6); the return is the exact root of the
/// gap (E5).
double margin(const Encounter& encounter, double far_speed) {
  Encounter e = encounter;
  const double escape = escape_speed(e);
  e.gap = {0.0, -std::hypot(far_speed, escape)};
  const auto contact = Passage(e, forever, Extent::through_first_contact).first_contact();
  return (contact && contact->end ? contact->exit_speed : 0.0) - escape;
}

/// None where every collision sticks.
std::optional<double> sticking_speed(const Encounter& e) {
  if (damping(e.normal_law(), e.mass) == 0.0) return 0.0;
  double high = escape_speed(e);
  int doublings = 0;
  while (!(margin(e, high) > 0.0)) {
    if (++doublings == 60) return std::nullopt;
    high *= 2.0;
  }
  std::uintmax_t iterations = 200;
  const auto bracket =
      boost::math::tools::toms748_solve([&e](double speed) { return margin(e, speed); }, 0.0, high,
                                        boost::math::tools::eps_tolerance<double>(50), iterations);
  return 0.5 * (bracket.first + bracket.second);
}

double source_restitution(const Encounter& e) {
  const LinearNormal& law = e.normal_law();
  if (const auto* given = std::get_if<Restitution>(&law.dissipation)) return given->value;
  const double eta = damping(law, e.mass);
  return law.no_tension ? no_tension_restitution_of(eta, law.stiffness, e.mass)
                        : restitution_of(eta, law.stiffness, e.mass);
}

void add_sticking_scalars(Solution& solution, const Encounter& e) {
  const double k_c = e.cohesion_stiffness();
  if (const auto speed = sticking_speed(e)) solution.scalars["sticking_speed"] = *speed;
  const double restitution = source_restitution(e);
  if (restitution == 0.0) return;
  solution.scalars["sticking_speed_source"] = sticking_speed_of_source(e.reach, k_c, restitution, e.mass);
}

/// Speed far away, from the energy at the start (cohesion.2); none for a start too slow to get there.
std::optional<double> far_speed(const Encounter& e) {
  const double inside = std::max(0.0, e.reach - e.gap.position);
  const double square = e.gap.velocity * e.gap.velocity - e.cohesion_stiffness() / e.mass * inside * inside;
  return square > 0.0 ? std::optional(std::sqrt(square)) : std::nullopt;
}

void add_outcome(Solution& solution, const Encounter& e, const Passage::Contact& contact) {
  const double escape = escape_speed(e);
  const bool sticks = !contact.end || contact.exit_speed <= escape;
  solution.scalars["sticks"] = sticks ? 1.0 : 0.0;
  if (contact.end) solution.scalars["return_speed"] = contact.exit_speed;
  const auto speed = far_speed(e);
  if (!speed) return;
  const double restitution = source_restitution(e);
  if (restitution > 0.0)
    solution.scalars["stickiness"] =
        stickiness_number(e.reach, e.cohesion_stiffness(), restitution, *speed, e.mass);
  const double squares = (contact.exit_speed - escape) * (contact.exit_speed + escape);
  solution.scalars["restitution"] = sticks ? 0.0 : std::sqrt(squares) / *speed;
}

}  // namespace

Solution cohesive_collision(const Scene& scene, double until) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (!(e.cohesion_stiffness() > 0.0)) return Solution::no("there is no cohesion");
  if (e.gravity != 0.0 || !e.gravity_across.isZero(0.0)) return Solution::no("gravity acts");
  if (!slides_freely(e)) return Solution::no("the velocity is not along the line of centres");
  if (e.gap.position < 0.0) return Solution::no("the bodies start in contact");
  const auto contact = Passage(e, forever, Extent::through_first_contact).first_contact();
  if (!contact) return Solution::no("the bodies never touch");
  Solution solution = solution_of(scene, e, Passage(e, until));
  add_contact_scalars(solution, *contact);
  add_outcome(solution, e, *contact);
  add_sticking_scalars(solution, e);
  return solution;
}

}  // namespace grainproof::analytic
