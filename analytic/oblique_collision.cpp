// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <optional>

#include "analytic/contact_scales.hpp"
#include "analytic/coulomb_slip.hpp"
#include "analytic/passage_solution.hpp"
#include "analytic/slip_friction.hpp"

/// Oblique collision that slides throughout, without gravity: friction.8 to friction.10. Exact on a
/// wall; for a pair it takes the normal as fixed from the moment of touching.
namespace grainproof::analytic {
namespace {

/// A pair whose normal turns further than this is refused rather than approximated.
constexpr double largest_turn = 0.01;  // rad

/// When the bodies touch, moving straight; none where they miss.
std::optional<double> touching_time(const Encounter& e) {
  if (!e.first) return e.gap.velocity < 0.0 ? std::optional(-e.gap.position / e.gap.velocity) : std::nullopt;
  const double distance = e.touching + e.gap.position;
  const double a = e.gap.velocity * e.gap.velocity + e.slip.squaredNorm();
  const double b = distance * e.gap.velocity;
  const double c = e.gap.position * (distance + e.touching);
  const double square = b * b - a * c;
  if (!(b < 0.0) || square < 0.0) return std::nullopt;
  return c / (-b + std::sqrt(square));
}

Scene moved_to(double time, Scene scene) {
  for (Particle& particle : scene.particles)
    if (!particle.fixed) particle.position += time * particle.velocity;
  for (Wall& wall : scene.walls)
    if (const Vec3 shift = time * wall_velocity(wall).value(); !shift.isZero(0.0))
      std::visit(Overloaded{[&](Rectangle& rectangle) {
                              rectangle.lower += shift;
                              rectangle.upper += shift;
                            },
                            [&](auto& shape) { shape.point += shift; }},
                 wall.shape);
  return scene;
}

/// Δu_t: friction.9 with `no_tension`, else friction.10.
double velocity_change(const Encounter& e, double coefficient, double normal_speed) {
  const LinearNormal& law = e.normal_law();
  const double eta = damping(law, e.mass);
  const double clamped = no_tension_restitution_of(eta, law.stiffness, e.mass);
  if (law.no_tension) return coefficient * (1.0 + clamped) * normal_speed;
  return coefficient * (1.0 + 2.0 * clamped - restitution_of(eta, law.stiffness, e.mass)) * normal_speed;
}

std::string why_not(const Encounter& e) {
  if (e.cohesion_stiffness() > 0.0) return "cohesion acts";
  if (e.gravity != 0.0 || !e.gravity_across.isZero(0.0)) return "gravity acts";
  if (head_on(e)) return "the velocity is along the line of centres";
  if (e.gap.position < 0.0) return "the bodies start in contact";
  return {};
}

/// Angle by which the line of centres of a pair turns in contact, from above; 0 on a wall.
double turn_of(const Encounter& e, const Passage::Contact& contact) {
  return e.first ? e.slip.norm() * *contact.end / e.touching : 0.0;
}

std::string why_not_sliding(const Encounter& e, const SlipFriction& friction, const CoulombSlip& slip,
                            const Push& push, double turn) {
  if (turn > largest_turn)
    return "the pair turns by up to " + std::to_string(turn) + " rad in contact; expected at most 0.01";
  const double static_force = slip.final_speed() * friction.viscosity;
  if (!(slip.final_speed() > 0.0 && static_force >= friction.coefficient * push.largest_force()))
    return "friction does not slide throughout";
  const Vec3 ran = slip.at(push.end()).position / e.slip.norm() * e.slip;
  return over_wall(e, ran) ? "" : "the sphere runs off the wall's edge";
}

/// `touching` is the scene at the moment `onset`, which `e` was recognised in.
std::function<Frame(double)> frames_of(const Scene& scene, const Scene& touching, const Encounter& e,
                                       double onset, const Passage& passage, const CoulombSlip& slip) {
  return [=, direction = Vec3(e.slip.normalized())](double time) {
    if (time < onset) return frame_of(moved_to(time, scene), time);
    const Motion slid = slip.at(time - onset);
    Frame frame = frame_of(touching, e, passage.at(time - onset),
                           {slid.position * direction, slid.velocity * direction}, time - onset);
    frame.time = time;
    frame.step = step_at_or_after(time, scene.run.step);
    return frame;
  };
}

Solution slide_through(const Scene& scene, const Scene& touching, const Encounter& e, double onset) {
  const Passage passage(e, std::numeric_limits<double>::infinity());
  const auto contact = passage.first_contact();
  if (!contact || !contact->end) return Solution::no("the contact never ends");
  const SlipFriction friction = slip_friction(e, scene.run.step);
  if (!friction.acts()) return Solution::no("there is no friction");
  const Push push(e, *contact);
  const CoulombSlip slip(push, friction.coefficient, e.slip.norm());
  const double turn = turn_of(e, *contact);
  if (const std::string because = why_not_sliding(e, friction, slip, push, turn); !because.empty())
    return Solution::no(because);
  Solution solution;
  solution.frame_at = frames_of(scene, touching, e, onset, passage, slip);
  add_contact_scalars(solution, *contact);
  solution.scalars["contact_onset_time"] = onset;
  solution.scalars["tangential_velocity_change"] =
      velocity_change(e, friction.coefficient, contact->entry_speed);
  solution.scalars["stable_step"] = stable_step(scene, e);
  if (e.first) solution.scalars["normal_turn"] = turn;
  return solution;
}

}  // namespace

Solution oblique_collision(const Scene& scene, double) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  if (const std::string because = why_not(found.encounter); !because.empty()) return Solution::no(because);
  const auto onset = touching_time(found.encounter);
  if (!onset) return Solution::no("the bodies never touch");
  const Scene touching = moved_to(*onset, scene);
  Recognised there = recognise(touching);
  if (!there.support) return Solution::no(there.support.because);
  there.encounter.gap.position = 0.0;
  return slide_through(scene, touching, there.encounter, *onset);
}

}  // namespace grainproof::analytic
