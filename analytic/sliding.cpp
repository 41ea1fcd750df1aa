// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>

#include "analytic/contact_scales.hpp"
#include "analytic/resting.hpp"
#include "analytic/slip_friction.hpp"

/// A sphere slides on a wall at its resting overlap: friction.4 to friction.7.
namespace grainproof::analytic {
namespace {

/// Sliding at the Coulomb limit down to the speed where the static branch is smaller; then an
/// exponential creep, or a stop (E9).
class Slide {
 public:
  Slide(const SlipFriction& friction, double mass, double weight, double speed)
      : speed_(speed),
        deceleration_(friction.coefficient * weight / mass),
        rate_(friction.viscosity / mass),
        creep_speed_(std::min(speed, deceleration_ / rate_)),
        creep_time_((speed - creep_speed_) / deceleration_) {}

  Motion at(double time) const {
    const double sliding = std::min(time, creep_time_);
    const double ran = (speed_ - 0.5 * deceleration_ * sliding) * sliding;
    if (time < creep_time_) return {ran, speed_ - deceleration_ * time};
    if (creep_speed_ == 0.0) return {ran, 0.0};
    const double after = -rate_ * (time - creep_time_);
    return {ran - creep_speed_ / rate_ * std::expm1(after), creep_speed_ * std::exp(after)};
  }

  bool stops() const { return creep_speed_ == 0.0; }
  double stop_time() const { return creep_time_; }
  double distance() const {
    return 0.5 * (speed_ + creep_speed_) * creep_time_ + (stops() ? 0.0 : creep_speed_ / rate_);
  }

 private:
  double speed_, deceleration_, rate_, creep_speed_, creep_time_;
};

std::string why_not(const Encounter& e) {
  if (e.first) return "there is no wall to slide on";
  if (std::string because = why_no_rest(e); !because.empty()) return because;
  if (e.gravity_across.norm() > 1e-12 * -e.gravity) return "gravity also pulls along the wall";
  const double rest = resting_overlap(e);
  // One part in 10⁹ of the overlap is what a position 10⁵ overlaps away from 0 still resolves.
  if (std::abs(e.gap.position + rest) > 1e-9 * rest) {
    std::ostringstream text;
    text.precision(17);
    text << "the sphere starts at overlap " << -e.gap.position
         << " m; expected its resting overlap m g/k = " << rest;
    return text.str();
  }
  if (e.slip.norm() == 0.0) return "the sphere does not slide";
  if (std::abs(e.gap.velocity) > 1e-12 * e.slip.norm())
    return "the sphere starts with a velocity along the normal";
  return {};
}

}  // namespace

Solution sliding(const Scene& scene, double until) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (const std::string because = why_not(e); !because.empty()) return Solution::no(because);
  const SlipFriction friction = slip_friction(e, scene.run.step);
  if (!friction.acts()) return Solution::no("there is no friction");
  const Slide slide(friction, e.mass, -e.mass * e.gravity, e.slip.norm());
  const Vec3 direction = e.slip.normalized();
  if (!over_wall(e, slide.at(until).position * direction))
    return Solution::no("the sphere runs off the wall's edge");
  Solution solution;
  solution.frame_at = [scene, e, slide, direction](double time) {
    const Motion slid = slide.at(time);
    return frame_of(scene, e, {e.gap.position, 0.0}, {slid.position * direction, slid.velocity * direction},
                    time);
  };
  solution.scalars = {{"resting_overlap", resting_overlap(e)},
                      {"stop_distance", slide.distance()},
                      {"stable_step", stable_step(scene, e)}};
  if (slide.stops()) solution.scalars["stop_time"] = slide.stop_time();
  return solution;
}

}  // namespace grainproof::analytic
