// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "analytic/affine_motion.hpp"
#include "analytic/contact_scales.hpp"
#include "analytic/hertz_encounter.hpp"
#include "analytic/resting.hpp"
#include "analytic/turning.hpp"

/// A sphere that friction's spring makes roll on a wall at its resting overlap, and that resistance to
/// rolling slows down: rolling.5 to rolling.8.
namespace grainproof::analytic {
namespace {

using State = Eigen::VectorXd;  ///< path, velocity, surface speed r ω, spring, resisting torque
enum { path, speed, surface, spring, torque };

constexpr double most_looks = 1e5;

struct Resisted {
  double mass, radius;
  double stiffness, damping;  ///< of the tangential spring
  double friction_limit;      ///< μ |F_n|, N
  double torque_limit;        ///< coefficient times r |F_n|, N m
  double rolling_stiffness;   ///< N m; 0 where the torque is constant

  /// rolling.5, with the torque at its limit or on its spring.
  AffineMotion motion(const State& start, bool at_limit) const {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5, 5);
    Eigen::RowVectorXd friction = Eigen::RowVectorXd::Zero(5);
    friction[speed] = damping, friction[surface] = -damping, friction[spring] = stiffness;
    a(path, speed) = 1.0;
    a.row(speed) = -friction / mass;
    a.row(surface) = 2.5 / mass * friction;
    a(surface, torque) = -2.5 / (mass * radius);
    a(spring, speed) = 1.0, a(spring, surface) = -1.0;
    if (!at_limit) a(torque, surface) = rolling_stiffness / radius;
    return {a, State::Zero(5), start};
  }

  double friction(const State& s) const { return stiffness * s[spring] + damping * (s[speed] - s[surface]); }

  /// Between two looks the quickest vibration does little.
  double look() const {
    const double rate = std::max(3.5 * stiffness, 2.5 * rolling_stiffness / (radius * radius)) / mass;
    return boost::math::constants::pi<double>() / 16.0 / std::sqrt(rate);
  }
};

struct Piece {
  double from;
  bool at_limit;
  AffineMotion motion;
};

/// Pieces in which the torque is on its spring, or at its limit until the sphere turns back.
class Roll {
 public:
  Roll(const Resisted& law, State start, double until) : law_(law) {
    const bool constant = law.rolling_stiffness == 0.0;
    if (constant) start[torque] = law.torque_limit;
    pieces_.push_back({0.0, constant, law.motion(start, constant)});
    double now = 0.0;
    const double look = law.look();
    State before = start;
    while (now < until && because_.empty()) {
      const double next = now + look;
      const State after = at(next);
      if (std::abs(law_.friction(after)) >= law_.friction_limit) because_ = "friction reaches its limit";
      now = crossed(before, after) ? change(now, next) : next;
      before = at(now);
    }
  }

  State at(double time) const { return piece_at(time).motion.at(time - piece_at(time).from); }
  const std::string& because() const { return because_; }

 private:
  const Piece& piece_at(double time) const {
    const auto next = std::upper_bound(pieces_.begin() + 1, pieces_.end(), time,
                                       [](double t, const Piece& later) { return t < later.from; });
    return *std::prev(next);
  }

  /// What passes zero where a piece ends.
  double sign(const State& s) const {
    return pieces_.back().at_limit ? s[surface] * s[torque] : law_.torque_limit - std::abs(s[torque]);
  }
  bool crossed(const State& before, const State& after) const {
    return sign(before) > 0.0 && sign(after) <= 0.0;
  }

  /// A new piece from the crossing on, and its time.
  double change(double from, double to) {
    std::uintmax_t iterations = 200;
    const auto bracket =
        boost::math::tools::toms748_solve([this](double time) { return sign(at(time)); }, from, to,
                                          boost::math::tools::eps_tolerance<double>(50), iterations);
    const double time = bracket.second;
    if (law_.rolling_stiffness == 0.0) because_ = "the sphere stops, and a constant torque then chatters";
    State start = at(time);
    const bool at_limit = !pieces_.back().at_limit;
    if (at_limit) start[torque] = std::copysign(law_.torque_limit, start[torque]);
    if (!at_limit) start[surface] = -std::copysign(0.0, start[torque]);
    pieces_.push_back({time, at_limit, law_.motion(start, at_limit)});
    return time;
  }

  Resisted law_;
  std::vector<Piece> pieces_;
  std::string because_;
};

std::string why_not(const Scene& scene, const Encounter& e, double rest) {
  if (e.first) return "there is no wall to roll on";
  if (std::string because = why_not_turning(scene, e); !because.empty()) return because;
  if (!std::holds_alternative<HistoryFriction>(e.laws.friction)) return "the friction has no spring";
  if (std::string because = why_no_rest(e); !because.empty()) return because;
  if (e.rectangle) return "the wall has edges";
  if (e.gravity_across.norm() > 1e-12 * -e.gravity) return "gravity also pulls along the wall";
  if (std::abs(e.gap.position + rest) > 1e-9 * rest) return "the sphere doesn't start at its resting overlap";
  if (std::abs(e.gap.velocity) > 1e-12 * e.slip.norm())
    return "the sphere starts with a velocity along the normal";
  const Vec3& spin = scene.particles[e.second].angular_velocity;
  const Vec3 across = spin.cross(e.normal);
  if (!(across.dot(e.slip) > 0.0)) return "the sphere doesn't roll at the start";
  if (across.cross(e.slip).norm() > 1e-12 * across.norm() * e.slip.norm())
    return "the spin turns the sphere's way";
  return std::abs(spin.dot(e.normal)) <= 1e-12 * spin.norm() ? "" : "the sphere also spins about the normal";
}

Resisted resisted(const Scene& scene, const Encounter& e, double rest) {
  const Rub rub = rub_of(scene, e, rest);
  const double radius = 0.5 * scene.particles[e.second].diameter, weight = -e.mass * e.gravity;
  Resisted law{e.mass, radius, rub.stiffness, 0.0, rub.coefficient * weight, 0.0, 0.0};
  std::visit(Overloaded{[](const NoRolling&) {},
                        [&](const ConstantTorqueRolling& rolling) {
                          law.torque_limit = rolling.coefficient * radius * weight;
                        },
                        [&](const SpringRolling& rolling) {
                          law.torque_limit = rolling.coefficient * radius * weight;
                          law.rolling_stiffness = rub.stiffness * radius * radius;
                        }},
             e.laws.rolling);
  const auto& history = std::get<HistoryFriction>(e.laws.friction);
  if (const auto* hertz = std::get_if<HertzNormal>(&e.laws.normal); hertz == nullptr)
    law.damping = history.damping_ratio * damping(e.normal_law(), e.mass);
  else
    law.damping = history.damping_ratio * hertz_pair_of(scene, e).damping(rub.stiffness);
  return law;
}

double rest_of(const Scene& scene, const Encounter& e) {
  if (std::holds_alternative<LinearNormal>(e.laws.normal)) return resting_overlap(e);
  return hertz_pair_of(scene, e).resting_overlap(-e.mass * e.gravity);
}

}  // namespace

Solution rolling_resistance(const Scene& scene, double until) {
  const Recognised found = recognise_rolling(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (std::holds_alternative<NoRolling>(e.laws.rolling)) return Solution::no("nothing resists rolling");
  if (!(e.gravity < 0.0)) return Solution::no("gravity does not pull towards the wall");
  const double rest = rest_of(scene, e);
  if (const std::string because = why_not(scene, e, rest); !because.empty()) return Solution::no(because);
  const Resisted law = resisted(scene, e, rest);
  if (!(until / law.look() < most_looks)) return Solution::no("the run holds more than 1e5 vibrations");
  const Vec3 direction = e.slip.normalized(), axis = e.normal.cross(direction);
  const Vec3 spin = scene.particles[e.second].angular_velocity;
  State start(5);
  start << 0.0, e.slip.norm(), law.radius * spin.cross(e.normal).norm(), 0.0, 0.0;
  const Roll roll(law, start, until);
  if (!roll.because().empty()) return Solution::no(roll.because());
  Solution solution;
  solution.frame_at = [=](double time) {
    const State s = roll.at(time);
    Frame frame =
        frame_of(scene, e, {e.gap.position, 0.0}, {s[path] * direction, s[speed] * direction}, time);
    frame.angular_velocity[e.second] = s[surface] / law.radius * axis;
    return frame;
  };
  solution.scalars["resting_overlap"] = rest;
  return solution;
}

}  // namespace grainproof::analytic
