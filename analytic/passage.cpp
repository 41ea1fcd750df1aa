// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/passage.hpp"

#include <algorithm>
#include <cmath>

#include "analytic/contact_scales.hpp"
#include "model/errors.hpp"

namespace grainproof::analytic {
namespace {

constexpr std::size_t most_phases = 100'000;

bool in_contact(const Phase& phase) {
  return phase.regime == Regime::pressed || phase.regime == Regime::released;
}

struct Event {
  double after;  ///< s from the start of the phase
  Regime next;
  std::optional<double> gap;  ///< where the event itself says it
};

/// The equation of the gap in every regime, and what ends it.
class Law {
 public:
  explicit Law(const Encounter& e)
      : mass_(e.mass),
        stiffness_(e.normal_law().stiffness),
        damping_(damping(e.normal_law(), e.mass)),
        // Without a dashpot nothing can pull, and releasing would coincide with leaving.
        no_tension_(e.normal_law().no_tension && damping_ > 0.0),
        attraction_(e.cohesion_stiffness()),
        reach_(e.reach),
        gravity_(e.gravity) {}

  LinearMotion motion(Regime regime, const Motion& start) const {
    const double weight = mass_ * gravity_, pull = attraction_ * reach_;
    switch (regime) {
      case Regime::apart:
        return {{mass_, 0.0, 0.0, weight}, start};
      case Regime::pressed:
        return {{mass_, stiffness_ - attraction_, damping_, weight - pull}, start};
      default:
        return {{mass_, -attraction_, 0.0, weight - pull}, start};
    }
  }

  Regime regime_of(const Motion& start) const {
    if (start.position < 0.0)
      return no_tension_ && contact_force(start) < 0.0 ? Regime::released : Regime::pressed;
    if (start.position == 0.0 && inward(start, attraction_ * reach_)) return Regime::pressed;
    if (start.position < reach_) return Regime::attracted;
    return start.position == reach_ && reach_ > 0.0 && inward(start, 0.0) ? Regime::attracted : Regime::apart;
  }

  std::optional<Event> next(const Phase& phase) const {
    const LinearMotion& gap = phase.motion;
    const auto at = [&gap](double level, Regime regime) -> std::optional<Event> {
      const auto time = gap.first_time_at(level);
      return time ? std::optional(Event{*time, regime, level}) : std::nullopt;
    };
    switch (phase.regime) {
      case Regime::apart:
        return reach_ > 0.0 ? at(reach_, Regime::attracted) : at(0.0, Regime::pressed);
      case Regime::attracted:
        return sooner(at(0.0, Regime::pressed), at(reach_, Regime::apart));
      case Regime::pressed:
        return no_tension_ ? force_zero(gap, Regime::released) : at(0.0, outside());
      default:
        return sooner(at(0.0, outside()), force_zero(gap, Regime::pressed));
    }
  }

  Regime outside() const { return reach_ > 0.0 ? Regime::attracted : Regime::apart; }

 private:
  double contact_force(const Motion& gap) const {
    return -stiffness_ * gap.position - damping_ * gap.velocity;
  }

  bool inward(const Motion& start, double pull) const {
    return start.velocity < 0.0 || (start.velocity == 0.0 && mass_ * gravity_ - pull < 0.0);
  }

  static std::optional<Event> sooner(const std::optional<Event>& a, const std::optional<Event>& b) {
    if (!a || !b) return a ? a : b;
    return a->after <= b->after ? a : b;
  }

  /// A phase that begins at force zero begins there exactly, not at its round-off.
  std::optional<Event> force_zero(const LinearMotion& gap, Regime regime) const {
    LinearMotion force = gap.combined(-stiffness_, -damping_);
    const double scale =
        stiffness_ * std::abs(gap.start().position) + damping_ * std::abs(gap.start().velocity);
    if (std::abs(force.start().position) < 1e-10 * scale)
      force = force.restarted({0.0, force.start().velocity});
    const auto time = force.first_time_at(0.0);
    return time ? std::optional(Event{*time, regime, std::nullopt}) : std::nullopt;
  }

  double mass_, stiffness_, damping_;
  bool no_tension_;
  double attraction_, reach_, gravity_;
};

}  // namespace

Passage::Passage(const Encounter& encounter, double until, Extent extent) {
  const Law law(encounter);
  const Regime first = law.regime_of(encounter.gap);
  phases_.push_back({0.0, first, law.motion(first, encounter.gap)});
  while (const auto event = law.next(phases_.back())) {
    const double from = phases_.back().from + event->after;
    if (from > until) return;
    if (phases_.size() == most_phases)
      throw EngineFailed("closed form: more than 100000 phases before the end");
    Motion start = phases_.back().motion.at(event->after);
    if (event->gap) start.position = *event->gap;
    Regime next = event->next;
    if (next == Regime::released && start.position >= 0.0) {
      next = law.outside();
      start.position = 0.0;
    }
    const bool leaves = in_contact(phases_.back()) && next == law.outside();
    phases_.push_back({from, next, law.motion(next, start)});
    if (leaves && extent == Extent::through_first_contact) return;
  }
}

Motion Passage::at(double time) const {
  auto phase = std::upper_bound(phases_.begin() + 1, phases_.end(), time,
                                [](double t, const Phase& later) { return t < later.from; });
  --phase;
  return phase->motion.at(time - phase->from);
}

std::optional<Passage::Contact> Passage::first_contact() const {
  const auto begin = std::find_if(phases_.begin(), phases_.end(), in_contact);
  if (begin == phases_.end()) return std::nullopt;
  const auto end = std::find_if_not(begin, phases_.end(), in_contact);
  const Motion& entry = begin->motion.start();
  Contact contact{begin->from, -entry.velocity, std::max(0.0, -entry.position), {}, {}};
  for (auto phase = begin; phase != end; ++phase) {
    if (phase->regime == Regime::released && !contact.released) contact.released = phase->from;
    if (const auto turn = phase->motion.turning_time();
        turn && (phase + 1 == phases_.end() || phase->from + *turn <= (phase + 1)->from))
      contact.peak_overlap = std::max(contact.peak_overlap, -phase->motion.at(*turn).position);
  }
  if (end != phases_.end()) {
    contact.end = end->from;
    contact.exit_speed = end->motion.start().velocity;
  }
  return contact;
}

}  // namespace grainproof::analytic
