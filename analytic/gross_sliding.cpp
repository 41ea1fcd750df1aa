// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <limits>

#include "analytic/contact_scales.hpp"
#include "analytic/coulomb_slip.hpp"
#include "analytic/hertz_encounter.hpp"
#include "analytic/hertz_passage.hpp"
#include "analytic/passage_solution.hpp"
#include "analytic/turning.hpp"

/// A sphere that turns strikes a wall obliquely, or a fixed sphere head-on, and slides throughout, without
/// gravity: rotation.9 and rotation.10; Chung and Ooi (2011), cases 5, 6 and 8. Exact on a wall; on a
/// sphere it takes the normal as fixed.
namespace grainproof::analytic {
namespace {

/// The normal motion from the onset on, by either law.
struct Impact {
  std::function<Motion(double)> gap;
  double force_zero, end;  ///< s, when the force first falls to zero, and from when there is none
  double exit_speed, peak_overlap, duration;
};

Impact linear_impact(Encounter e) {
  e.gap.position = 0.0;
  const Passage passage(e, std::numeric_limits<double>::infinity());
  const auto contact = passage.first_contact();
  if (!contact || !contact->end) return {};
  const Push push(e, *contact);
  return {[passage](double time) { return passage.at(time); },
          push.force_zero(),
          push.end(),
          contact->exit_speed,
          contact->peak_overlap,
          *contact->end};
}

Impact hertz_impact(const Scene& scene, const Encounter& e) {
  const HertzPassage passage(hertz_pair_of(scene, e), -e.gap.velocity);
  return {[passage](double time) { return passage.gap(time); },
          passage.force_zero(),
          passage.duration(),
          passage.exit_speed(),
          passage.peak_overlap(),
          passage.duration()};
}

/// On a sphere whose line of centres turns further than this it is refused rather than approximated.
constexpr double largest_turn = 0.01;  // rad

std::string why_not(const Scene& scene, const Encounter& e) {
  if (e.first && !scene.particles[*e.first].fixed) return "both spheres move";
  if (e.first && !head_on(e)) return "the velocity is not along the line of centres";
  if (std::string because = why_not_turning(scene, e); !because.empty()) return because;
  if (e.gravity != 0.0 || !e.gravity_across.isZero(0.0)) return "gravity acts";
  if (starts_in_contact(e)) return "the sphere starts in contact";
  if (!(e.gap.velocity < 0.0)) return "the bodies never touch";
  return slip_of(scene, e).norm() > 0.0 ? "" : "the sphere does not slip";
}

/// k/k_t by the linear law, E*/(6 G*) by Hertz' (history.10).
double compliance_ratio(const Scene& scene, const Encounter& e, double spring) {
  if (std::holds_alternative<LinearNormal>(e.laws.normal)) return e.normal_law().stiffness / spring;
  const HertzPair pair = hertz_pair_of(scene, e);
  const auto* history = std::get_if<HistoryFriction>(&e.laws.friction);
  // What is kept of the force grows by k_t u alone: two thirds of k_t ζ at first (history.12).
  const double kept = history && history->memory == SpringMemory::force ? 1.5 : 1.0;
  return kept * pair.modulus / (6.0 * pair.shear_modulus);
}

bool elastic(const Scene& scene, const Encounter& e) {
  if (std::holds_alternative<LinearNormal>(e.laws.normal)) return damping(e.normal_law(), e.mass) == 0.0;
  return hertz_pair_of(scene, e).damping_ratio == 0.0;
}

std::string why_not_sliding(const Scene& scene, const Encounter& e, double left) {
  if (!(left > 0.0)) return "the sphere stops slipping while it touches";
  if (!std::holds_alternative<HistoryFriction>(e.laws.friction)) return "";
  if (!elastic(scene, e)) return "a spring sticks at first where the contact is damped";
  const Rub rub = rub_of(scene, e, 0.0);
  const double fastest = rub.coefficient * compliance_ratio(scene, e, rub.stiffness) * -e.gap.velocity;
  return slip_of(scene, e).norm() >= fastest ? "" : "the tangential spring is slower than its limit at first";
}

}  // namespace

Solution gross_sliding(const Scene& scene, double until) {
  const Recognised found = recognise_bodies(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (const std::string because = why_not(scene, e); !because.empty()) return Solution::no(because);
  const bool linear = std::holds_alternative<LinearNormal>(e.laws.normal);
  if (!linear && hertz_pair_of(scene, e).damping_ratio >= 1.0)
    return Solution::no("the contact is critically or over-damped");
  const Impact impact = linear ? linear_impact(e) : hertz_impact(scene, e);
  if (!impact.gap) return Solution::no("the contact never ends");
  const Vec3 direction = slip_of(scene, e).normalized();
  const double speed = -e.gap.velocity, onset = e.gap.position / speed;
  // What friction takes off the sphere's velocity along the slip, as a motion from rest.
  const CoulombSlip taken(impact.gap, impact.force_zero, impact.end, rub_of(scene, e, 0.0).coefficient, 0.0);
  const double left = slip_of(scene, e).norm() + 3.5 * taken.final_speed();
  if (const std::string because = why_not_sliding(scene, e, left); !because.empty())
    return Solution::no(because);
  const auto taken_at = [taken, onset](double time) {
    return time > onset ? taken.at(time - onset) : Motion{0.0, 0.0};
  };
  const auto path_at = [=](double time) -> Vec3 {
    return time * e.slip + taken_at(time).position * direction;
  };
  if (e.first && path_at(onset + impact.duration).norm() > largest_turn * e.touching)
    return Solution::no("the line of centres turns by more than 0.01 rad");
  if (!over_wall(e, path_at(onset)) || !over_wall(e, path_at(std::min(until, onset + impact.duration))))
    return Solution::no("the sphere runs off the wall's edge");
  Solution solution;
  solution.frame_at = [=](double time) {
    const Motion gap =
        time < onset ? Motion{e.gap.position - speed * time, -speed} : impact.gap(time - onset);
    return frame_of_sphere(scene, e, gap, path_at(time), -taken_at(time).velocity * direction, time);
  };
  solution.scalars = {{"contact_onset_time", onset},
                      {"peak_overlap", impact.peak_overlap},
                      {"contact_duration", impact.duration},
                      {"restitution", impact.exit_speed / speed},
                      {"tangential_velocity_change", -3.5 * taken.final_speed()}};
  return solution;
}

}  // namespace grainproof::analytic
