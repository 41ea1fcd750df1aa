// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "analytic/contact_scales.hpp"
#include "analytic/resting.hpp"

/// A sphere that doesn't turn, at its resting overlap on a wall, on a tangential spring: history.13 to
/// history.16. It sticks and slips by turns; each piece is a damped vibration or a parabola.
namespace grainproof::analytic {
namespace {

constexpr std::size_t most_pieces = 100'000;

struct Rubbing {
  double mass, stiffness, damping;
  double limit;  ///< μ |F_n|, N
  bool on_sum;   ///< the limit is put on spring and dashpot together
  double pull;   ///< of gravity along the wall, N
};

/// `slipping`: 0 while it sticks, else the direction of the slip. A stuck piece moves the spring's
/// displacement, a slipping one the path.
struct Piece {
  double from;
  int slipping;
  LinearMotion motion;
  double shift;  ///< path less `motion`'s position
};

class StickSlip {
 public:
  StickSlip(const Rubbing& rub, double speed, double until) : rub_(rub) {
    pieces_.push_back(first(speed));
    while (pieces_.size() < most_pieces && pieces_.back().from <= until && add_next()) {
    }
  }

  Motion at(double time) const {
    auto piece = std::upper_bound(pieces_.begin() + 1, pieces_.end(), time,
                                  [](double t, const Piece& later) { return t < later.from; });
    --piece;
    const Motion moved = piece->motion.at(time - piece->from);
    return {moved.position + piece->shift, moved.velocity};
  }

  std::size_t slips() const {
    return static_cast<std::size_t>(
        std::count_if(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.slipping != 0; }));
  }

 private:
  /// A dashpot may already be at the limit when the spring has not been stretched.
  Piece first(double speed) const {
    const int way = speed < 0.0 ? -1 : 1;
    const bool slips = rub_.on_sum && rub_.damping * std::abs(speed) > rub_.limit &&
                       std::abs(speed) > std::abs(parting_speed(way));
    return slips ? slipping(0.0, way, {0.0, speed}) : sticking(0.0, 0.0, {0.0, speed});
  }

  Piece sticking(double from, double path, const Motion& spring) const {
    return {from, 0, {{rub_.mass, rub_.stiffness, rub_.damping, rub_.pull}, spring}, path - spring.position};
  }

  Piece slipping(double from, int way, const Motion& path) const {
    return {from, way, {{rub_.mass, 0.0, 0.0, rub_.pull - way * rub_.limit}, path}, 0.0};
  }

  /// The slip's speed at which spring and dashpot no longer outgrow the limit (history.15).
  double parting_speed(int way) const {
    if (!rub_.on_sum) return 0.0;
    return -rub_.damping / rub_.stiffness * (rub_.pull - way * rub_.limit) / rub_.mass;
  }

  bool add_next() {
    const Piece& now = pieces_.back();
    return now.slipping == 0 ? add_slip(now) : add_stick(now);
  }

  bool add_slip(const Piece now) {
    const bool kept = pieces_.size() > 1;
    LinearMotion force = rub_.on_sum ? now.motion.combined(rub_.stiffness, rub_.damping)
                                     : now.motion.combined(rub_.stiffness, 0.0);
    // After a slip the force starts at the limit exactly, not at its round-off.
    if (kept)
      force = force.restarted({std::copysign(rub_.limit, force.start().position), force.start().velocity});
    std::optional<double> soonest;
    int way = 0;
    for (const int side : {-1, 1}) {
      const auto reached = force.first_time_at(side * rub_.limit);
      if (!reached || (soonest && *reached >= *soonest)) continue;
      soonest = reached;
      way = side;
    }
    if (!soonest) return false;
    const Motion moved = now.motion.at(*soonest);
    pieces_.push_back(slipping(now.from + *soonest, way, {moved.position + now.shift, moved.velocity}));
    return true;
  }

  bool add_stick(const Piece now) {
    const double end = parting_speed(now.slipping);
    const double rate = (rub_.pull - now.slipping * rub_.limit) / rub_.mass;
    const double left = now.slipping * (now.motion.start().velocity - end);
    if (left > 0.0 && !(now.slipping * rate < 0.0)) return false;
    const double after = left > 0.0 ? left / std::abs(rate) : 0.0;
    const Motion path = now.motion.at(after);
    const double dashpot = rub_.on_sum ? rub_.damping * path.velocity : 0.0;
    const double spring = (now.slipping * rub_.limit - dashpot) / rub_.stiffness;
    pieces_.push_back(sticking(now.from + after, path.position, {spring, path.velocity}));
    return true;
  }

  Rubbing rub_;
  std::vector<Piece> pieces_;
};

std::string why_not(const Scene& scene, const Encounter& e) {
  if (scene.rotation) return "the sphere turns";
  if (e.first) return "there is no wall to slide on";
  if (!std::holds_alternative<HistoryFriction>(e.laws.friction)) return "the friction has no spring";
  if (std::string because = why_no_rest(e); !because.empty()) return because;
  const double rest = resting_overlap(e);
  if (std::abs(e.gap.position + rest) > 1e-9 * rest) {
    std::ostringstream text;
    text.precision(17);
    text << "the sphere starts at overlap " << -e.gap.position
         << " m; expected its resting overlap m g/k = " << rest;
    return text.str();
  }
  if (std::abs(e.gap.velocity) > 1e-12 * e.slip.norm())
    return "the sphere starts with a velocity along the normal";
  if (e.slip.isZero(0.0) && e.gravity_across.isZero(0.0)) return "nothing moves the sphere along the wall";
  const double turned = e.slip.cross(e.gravity_across).norm();
  return turned <= 1e-12 * e.slip.norm() * e.gravity_across.norm() ? "" : "the slip turns";
}

Rubbing rubbing_of(const Encounter& e, const Vec3& direction) {
  const auto& law = std::get<HistoryFriction>(e.laws.friction);
  return {e.mass,
          law.stiffness,
          law.damping_ratio * damping(e.normal_law(), e.mass),
          -law.coefficient * e.mass * e.gravity,
          law.limit == CoulombLimit::spring_and_dashpot,
          e.mass * e.gravity_across.dot(direction)};
}

}  // namespace

Solution stick_slip(const Scene& scene, double until) {
  const Recognised found = recognise(scene);
  if (!found.support) return Solution::no(found.support.because);
  const Encounter& e = found.encounter;
  if (const std::string because = why_not(scene, e); !because.empty()) return Solution::no(because);
  const Vec3 direction = (e.slip.isZero(0.0) ? e.gravity_across : e.slip).normalized();
  const StickSlip slide(rubbing_of(e, direction), e.slip.norm(), until);
  Solution solution;
  solution.frame_at = [scene, e, slide, direction](double time) {
    const Motion slid = slide.at(time);
    return frame_of(scene, e, {e.gap.position, 0.0}, {slid.position * direction, slid.velocity * direction},
                    time);
  };
  solution.scalars = {{"resting_overlap", resting_overlap(e)}, {"slips", static_cast<double>(slide.slips())}};
  return solution;
}

}  // namespace grainproof::analytic
