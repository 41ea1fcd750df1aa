// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/crowd_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

#include "analytic/crowd.hpp"
#include "analytic/schemes.hpp"

namespace grainproof::analytic {
namespace {

/// Of the contacts that a material can have: the stiffest and most damped of each kind.
struct Stiffest {
  double normal = 0.0, tangential = 0.0, spin = 0.0;

  void add(double along, double across, double turning) {
    normal = std::max(normal, along);
    tangential = std::max(tangential, across);
    spin = std::max(spin, turning);
  }
};

struct Body {
  double mass;
  Crowd crowd;
};

/// Largest eigenvalue of a body's own block of the matrix of springs, times its mass: one for its path, one
/// for its turning, each with what couples them (stability.7).
double block(const Stiffest& stiffest, const Crowd& crowd) {
  const double excess = stiffest.normal - stiffest.tangential;
  const double path = excess > 0.0 ? excess * crowd.along + stiffest.tangential * crowd.contacts
                                   : stiffest.normal * crowd.contacts - excess * crowd.across;
  const double turn = stiffest.spin * stiffest.tangential * crowd.across;
  return std::max(path, turn) + std::sqrt(stiffest.spin) * stiffest.tangential * crowd.resultant;
}

bool creeps(const ContactLoad& load) {
  return load.creep_stiffness > 0.0 || load.creep_damping > 0.0;
}

class CrowdLimit {
 public:
  CrowdLimit(const Scene& scene, const std::vector<ContactLoad>& loads)
      : scene_(scene),
        scheme_(linear_scheme(scene.run.integrator)),
        springs_(scene.materials.size()),
        dashpots_(scene.materials.size()) {
    for (const ContactLoad& load : loads) {
      const auto& [one, other] = load.contact.materials;
      for (const std::size_t material : {one, other}) {
        springs_[material].add(
            scheme_.flip.stiffness * load.scale.stiffness,
            scheme_.flip.remembered * load.tangential_stiffness + scheme_.flip.damping * load.creep_stiffness,
            load.spin);
        dashpots_[material].add(load.crowded_damping * load.scale.damping,
                                load.crowded_damping * load.tangential_damping + load.creep_damping,
                                load.spin);
      }
    }
  }

  double step_of(const ContactLoad& load) const {
    const auto& [one, other] = load.contact.materials;
    const auto [first, second] = bodies_of(load);
    if (first.crowd.alone() && second.crowd.alone()) return std::numeric_limits<double>::infinity();
    const auto over_both = [&](const std::vector<Stiffest>& stiffest) {
      return block(stiffest[one], first.crowd) / first.mass +
             block(stiffest[other], second.crowd) / second.mass;
    };
    const double drag = scheme_.flip.drag > 0.0 ? load.contact.fastest_drag : load.contact.slowest_drag;
    // Springs stand with the flip condition's own factors already.
    const LinearScheme weighted{
        scheme_.name, scheme_.step, {1.0, 1.0, scheme_.flip.damping, scheme_.flip.drag}};
    return flip_limit(weighted, {1.0, over_both(springs_), 0.0, over_both(dashpots_), drag});
  }

  std::string reason_of(const ContactLoad& load) const {
    const auto [first, second] = bodies_of(load);
    const double contacts = std::max(std::isinf(first.mass) ? 0.0 : first.crowd.contacts,
                                     std::isinf(second.mass) ? 0.0 : second.crowd.contacts);
    std::ostringstream because;
    because << "bodies of " << load.scale.between << " with up to " << contacts << " contacts at once under "
            << scheme_.name;
    if (creeps(load)) because << "; above it those with friction chatter where they should come to rest";
    return because.str();
  }

 private:
  std::pair<Body, Body> bodies_of(const ContactLoad& load) const {
    const PossibleContact& contact = load.contact;
    return {{contact.masses.first, crowd_of(contact.diameters.first)},
            {contact.masses.second, crowd_of(contact.diameters.second)}};
  }

  /// Looked up: a large scene has few diameters that are the lightest of something.
  Crowd crowd_of(double diameter) const {
    if (std::isinf(diameter)) return {0.0, 0.0, 0.0, 0.0};
    const auto found = crowds_.find(diameter);
    if (found != crowds_.end()) return found->second;
    return crowds_[diameter] = analytic::crowd_of(scene_, diameter);
  }

  const Scene& scene_;
  const LinearScheme& scheme_;
  std::vector<Stiffest> springs_, dashpots_;  ///< of each material
  mutable std::map<double, Crowd> crowds_;    ///< by diameter
};

}  // namespace

StepLimit crowd_limit(const Scene& scene, const std::vector<ContactLoad>& loads) {
  const CrowdLimit limits(scene, loads);
  double step = std::numeric_limits<double>::infinity();
  const ContactLoad* worst = nullptr;
  for (const ContactLoad& load : loads)
    if (const double one = limits.step_of(load); one < step) {
      step = one;
      worst = &load;
    }
  return {step, worst == nullptr ? "no body can have two contacts" : limits.reason_of(*worst)};
}

}  // namespace grainproof::analytic
