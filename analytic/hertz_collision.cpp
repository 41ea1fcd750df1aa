// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "analytic/contact_scales.hpp"
#include "analytic/hertz_encounter.hpp"
#include "analytic/hertz_passage.hpp"
#include "analytic/passage_solution.hpp"

/// Head-on collision by Hertz' law without gravity, elastic or damped: hertz.9 to hertz.11.
namespace grainproof::analytic {
namespace {

std::string why_not(const Scene& scene, const Encounter& e) {
  if (!std::holds_alternative<HertzNormal>(e.laws.normal)) return "the contact is linear";
  if (e.cohesion_stiffness() > 0.0) return "cohesion acts";
  if (e.gravity != 0.0 || !e.gravity_across.isZero(0.0)) return "gravity acts";
  if (!slides_freely(e)) return "the velocity is not along the line of centres";
  if (!std::holds_alternative<Frictionless>(e.laws.friction) && spins_rub(scene, e))
    return "a particle spins, and friction acts";
  if (starts_in_contact(e)) return "the bodies start in contact";
  return e.gap.velocity < 0.0 ? "" : "the bodies never touch";
}

void add_scalars(Solution& solution, const HertzPassage& passage, const HertzPair& pair, double speed) {
  solution.scalars["peak_overlap"] = passage.peak_overlap();
  solution.scalars["contact_duration"] = passage.duration();
  solution.scalars["restitution"] = passage.exit_speed() / speed;
  if (pair.damping_ratio == 0.0) solution.scalars["peak_force"] = passage.largest_force();
}

}  // namespace

Solution hertz_collision(const Scene& scene, double) {
  const Recognised found = recognise_bodies(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (const std::string because = why_not(scene, e); !because.empty()) return Solution::no(because);
  const double speed = -e.gap.velocity, onset = e.gap.position / speed;
  const HertzPair pair = hertz_pair_of(scene, e);
  if (pair.damping_ratio >= 1.0) return Solution::no("the contact is critically or over-damped");
  const HertzPassage passage(pair, speed);
  Solution solution;
  solution.frame_at = [scene, e, passage, onset, speed](double time) {
    const Motion gap =
        time < onset ? Motion{e.gap.position - speed * time, -speed} : passage.gap(time - onset);
    return frame_of(scene, e, gap, {e.slip * time, e.slip}, time);
  };
  add_scalars(solution, passage, pair, speed);
  solution.scalars["contact_onset_time"] = onset;
  return solution;
}

}  // namespace grainproof::analytic
