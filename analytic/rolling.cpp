// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <sstream>

#include "analytic/hertz_encounter.hpp"
#include "analytic/resting.hpp"
#include "analytic/turning.hpp"

/// A sphere slides into rolling on a wall at its resting overlap: rotation.6 to rotation.8.
namespace grainproof::analytic {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The slip and its path, along its direction.
class RollingSlip {
 public:
  /// `stiffness` infinite: no spring.
  RollingSlip(double speed, double coefficient, double gravity, double stiffness, double mass)
      : speed_(speed), deceleration_(3.5 * coefficient * gravity) {
    if (!std::isinf(stiffness)) {
      stretch_ = coefficient * mass * gravity / stiffness;
      frequency_ = std::sqrt(3.5 * stiffness / mass);
      const double sine = stretch_ * frequency_ / speed;
      loaded_ = sine < 1.0 ? std::asin(sine) / frequency_ : never;
    }
    if (loaded_ == never) return;
    sliding_from_ = frequency_ > 0.0 ? loading(loaded_) : Motion{0.0, speed};
    rolling_ = loaded_ + sliding_from_.velocity / deceleration_;
  }

  Motion at(double time) const {
    if (time < loaded_) return loading(time);
    if (time < rolling_) return sliding(time - loaded_);
    const double path = sliding(rolling_ - loaded_).position, angle = frequency_ * (time - rolling_);
    return {path + stretch_ * (std::cos(angle) - 1.0), -stretch_ * frequency_ * std::sin(angle)};
  }

  double rolling_time() const { return rolling_; }

 private:
  Motion loading(double time) const {
    const double angle = frequency_ * time;
    return {speed_ / frequency_ * std::sin(angle), speed_ * std::cos(angle)};
  }
  Motion sliding(double time) const {
    return {(sliding_from_.velocity - 0.5 * deceleration_ * time) * time + sliding_from_.position,
            sliding_from_.velocity - deceleration_ * time};
  }

  double speed_, deceleration_;
  double stretch_ = 0.0, frequency_ = 0.0;  ///< ζ0 and Ω
  double loaded_ = 0.0, rolling_ = never;   ///< s
  Motion sliding_from_{0.0, 0.0};
};

double rest_of(const Scene& scene, const Encounter& e) {
  if (std::holds_alternative<LinearNormal>(e.laws.normal)) return resting_overlap(e);
  return hertz_pair_of(scene, e).resting_overlap(-e.mass * e.gravity);
}

bool damped(const Encounter& e) {
  const auto* history = std::get_if<HistoryFriction>(&e.laws.friction);
  return history && history->damping_ratio > 0.0;
}

std::string why_not(const Scene& scene, const Encounter& e) {
  if (e.first) return "there is no wall to turn on";
  if (std::string because = why_not_turning(scene, e); !because.empty()) return because;
  if (damped(e)) return "the tangential spring is damped";
  if (std::string because = why_no_rest(e); !because.empty()) return because;
  if (e.gravity_across.norm() > 1e-12 * -e.gravity) return "gravity also pulls along the wall";
  const double rest = rest_of(scene, e), slip = slip_of(scene, e).norm();
  if (std::abs(e.gap.position + rest) > 1e-9 * rest) {
    std::ostringstream text;
    text.precision(17);
    text << "the sphere starts at overlap " << -e.gap.position << " m; expected its resting overlap " << rest;
    return text.str();
  }
  if (slip == 0.0) return "the sphere does not slide";
  if (std::abs(e.gap.velocity) > 1e-12 * slip) return "the sphere starts with a velocity along the normal";
  return rub_of(scene, e, rest).coefficient > 0.0 ? "" : "there is no friction";
}

}  // namespace

Solution rolling(const Scene& scene, double until) {
  const Recognised found = recognise_bodies(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (const std::string because = why_not(scene, e); !because.empty()) return Solution::no(because);
  const double rest = rest_of(scene, e);
  const Rub rub = rub_of(scene, e, rest);
  const Vec3 start = slip_of(scene, e), direction = start.normalized();
  const RollingSlip slip(start.norm(), rub.coefficient, -e.gravity, rub.stiffness, e.mass);
  Solution solution;
  // The sphere goes at its first velocity less 2/7 of what the slip has lost (rotation.4).
  const auto path_at = [e, slip, start, direction](double time) -> Vec3 {
    return time * (e.slip - 2.0 / 7.0 * start) + 2.0 / 7.0 * slip.at(time).position * direction;
  };
  if (!over_wall(e, path_at(until))) return Solution::no("the sphere runs off the wall's edge");
  solution.frame_at = [=](double time) {
    const Vec3 lost = 2.0 / 7.0 * (start - slip.at(time).velocity * direction);
    return frame_of_sphere(scene, e, {e.gap.position, 0.0}, path_at(time), lost, time);
  };
  solution.scalars["resting_overlap"] = rest;
  solution.scalars["rolling_speed"] = (e.slip - 2.0 / 7.0 * start).norm();
  if (slip.rolling_time() < never) solution.scalars["rolling_time"] = slip.rolling_time();
  return solution;
}

}  // namespace grainproof::analytic
