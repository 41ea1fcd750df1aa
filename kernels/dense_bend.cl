// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// (integrators.21): where the Coulomb limit takes hold of spring and dashpot within a step friction bends, and the
// trapezoid rule misses a part of the second order. Impulses are those on the body itself.
#define LEAST_SHARE ((real)1e-3f)

typedef struct {
  Vectors pull;  // of spring and dashpot against the slip, whatever the limit
  reals most;
} Hold;

INLINE reals lengths_of(Vectors a) { return roots_of(inner(a, a)); }

INLINE Vectors held_back(Vectors pull, reals most) {
  const reals size = lengths_of(pull);
  return scaled(pull, size > most ? most / size : 1);
}

// Of friction whose pull goes evenly from `first` to `last`, under a limit that goes evenly too.
INLINE Vectors rub_between(Vectors first, Vectors last, reals most_first, reals most_last, reals time) {
  const Vectors held = held_back(first, most_first);
  const Vectors even = scaled(plus_scaled(held, last, (reals)(1)), (real)-0.5f * time);
  const reals length = lengths_of(last), excess = length - most_last;
  const Vectors along = scaled(last, length > 0 ? 1 / length : 0);
  const reals space = most_first - inner(held, along), room = space > 0 ? space : 0;
  return plus_scaled(even, along, excess > 0 ? (real)0.5f * time * excess * (excess / (room + excess)) : 0);
}

// What dashpots are told less what was true: so much of what is foretold for now, so much of what was before.
typedef struct {
  reals now, before;
} Untruth;

INLINE Untruth untruth_of(reals mobility, real stiffness, reals damping, real step) {
  const reals c = (real)0.5f * step * damping * mobility, kappa = (real)0.5f * step * step * stiffness * mobility;
  const Untruth u = {(1 + c) / (1 + c + kappa) - (1 - (real)0.5f * kappa) / (1 + c), ((real)0.5f * kappa - c) / (1 + c)};
  return u;
}

INLINE Untruth untruth_of_alike(Untrue all) {
  const Untruth u = {(reals)(all.now), (reals)(all.before)};
  return u;
}

// At the last boundary, as dashpots were told. held: springs of then, in the plane of now.
INLINE Hold hold_before(Meeting m, Before b, Vectors held, PairLaw law, real step) {
  const reals damping = spring_dashpot_of(law, m.root_mass), across = dashpot_of(law, m.root_mass);
  const bool alike = ALL_ALIKE && m.rolls;
  const reals mobility = 1 / (m.root_mass * m.root_mass);
  const Untruth n = alike ? untruth_of_alike(m.alike.untrue_rate) : untruth_of(mobility, law.stiffness, across, step);
  const Untruth t = alike ? untruth_of_alike(m.alike.untrue_slip) : untruth_of(m.mobility, law.spring, damping, step);
  const reals wrong = fma(n.now, -inner(m.velocity, m.normal), n.before * b.rate);
  const reals told = fma(across, wrong, b.force), push = told > law.lowest ? told : law.lowest;
  const Vectors slip = plus_scaled(scaled(b.slip, 1 + t.before), plus_scaled(b.slip, b.gain, (reals)(1)), t.now);
  const Hold h = {plus_scaled(scaled(slip, damping), held, (reals)(law.spring)), law.sliding * magnitudes(push)};
  return h;
}

INLINE void add_rub(Push* total, Meeting m, Vectors rub, real step) {
  if (ROTATION) add(&total->twist, scaled(outer(m.normal, rub), m.arm * (-1 / step)), total->torque_unit);
  add(&total->impulse, scaled(rub, (reals)(1 / step)), total->force_unit);
  total->corrected = true;
}

// When forces that go from `first` to `last` in a step pass zero, their second derivatives being the same all along.
INLINE reals zero_between(reals first, reals last, reals second, real step) {
  const reals slope = (last - first) * (1 / step) - (real)0.5f * step * second;
  const reals square = slope * slope - 2 * second * first, there = roots_of(square > 0 ? square : 0);
  const reals time = 2 * magnitudes(first) / (there - (first > 0 ? slope : -slope));
  return time > 0 ? (time < step ? time : (reals)(step)) : 0;
}

// Friction falls to nothing with the limit, and contacts that have gripped anew go on from the slip of then. last: what
// the normal force comes to. Returns the impulse until then, less what the plain scheme has of the last boundary.
INLINE Vectors follow_through_zero(Meeting* m, flags turns, Before b, reals last, Vectors slip, PairLaw law,
                                   Vectors* spring, real step) {
  const reals damping = spring_dashpot_of(law, m->root_mass), across = dashpot_of(law, m->root_mass);
  const reals mobility = 1 / (m->root_mass * m->root_mass), change = law.stiffness * b.rate - across * mobility * b.force;
  const reals zero = zero_between(b.force, last, -mobility * (law.stiffness * b.force + across * change), step);
  const reals until = turns ? zero : 0;
  const Hold before = hold_before(*m, b, carried_springs(*spring, *m, law.history), law, step);
  const Vectors held = held_back(before.pull, before.most);
  const reals grows = (real)0.5f * law.spring + damping * (1 / step), left = step - until;
  const Vectors growth = plus_scaled(scaled(b.slip, law.spring), b.gain, grows);
  const Vectors rub = rub_between(held, plus_scaled(held, growth, until), before.most, (reals)(0), until);
  const Vectors drift = plus_scaled(scaled(b.gain, 1 / step), held, m->mobility);  // by all but this friction
  const Vectors then = plus_scaled(plus_scaled(b.slip, drift, until), rub, m->mobility);
  const reals slowed = fma((real)-0.5f * law.spring * m->mobility, left * left, (reals)(1));
  const Vectors now = plus_scaled(scaled(then, slowed), drift, left);
  *spring = chosen(turns, scaled(then, -damping / law.spring), *spring);
  m->stretching = chosen(turns, now, m->stretching);
  m->duration = turns ? left : m->duration;
  m->foreseen_slip = turns ? 1 : m->foreseen_slip;
  m->velocity = chosen(turns, plus_scaled(m->velocity, less(now, slip), (reals)(1)), m->velocity);
  return plus_scaled(rub, held, (reals)((real)0.5f * step));
}

// Contacts that end. In two parts where the normal force passes zero before.
INLINE Vectors rub_of_bent_end(Meeting m, flags ends, Before b, Flow f, reals time, PairLaw law, Swing swing,
                               Vectors spring, real step) {
  const reals damping = spring_dashpot_of(law, m.root_mass), lowest = law.lowest;
  const reals end = full_force(b.overlap + time * b.rate + f.way, b.rate + f.gain, law, m.root_mass);
  const reals first = b.force > lowest ? b.force : lowest, last = end > lowest ? end : lowest;
  const Vectors pull = plus_scaled(scaled(b.slip, damping), spring, (reals)(law.spring));
  const Vectors growth = plus_scaled(scaled(b.slip, law.spring), b.gain, damping * (1 / step));
  const reals most = law.sliding * magnitudes(first), most_last = law.sliding * magnitudes(last);
  const Vectors whole = rub_between(pull, plus_scaled(pull, growth, time), most, most_last, time);
  const flags crosses = ends & (first > 0) & (last < 0);
  if (!any_of(crosses)) return whole;
  const reals change = law.stiffness * b.rate - swing.damping * first;
  const reals zero = parting_time(crosses ? first : 0, change, step, swing);
  const reals until = zero < time ? zero : time, rest = time - until;
  const Vectors rub = rub_between(pull, plus_scaled(pull, growth, until), most, (reals)(0), until);
  const Vectors slip = plus_scaled(b.slip, rub, m.mobility);
  const Vectors again = scaled(slip, law.spring * rest);
  const Vectors second = rub_between(vectors(0, 0, 0), again, (reals)(0), most_last, rest);
  return chosen(crosses, plus_scaled(rub, second, (reals)(1)), whole);
}

// Of contacts that have turned over; rub: as it says above, g: of what they did at the step's end.
INLINE void end_turnover(Push* total, Meeting m, flags turns, Vectors rub, Grasp g, PairLaw law, real step) {
  if (!bends(law) || !(law.lowest < 0)) return;
  const Vectors rubbed = plus_scaled(rub, g.rubbing, (real)0.5f * (m.duration - step));
  add_rub(total, m, chosen(turns, rubbed, vectors(0, 0, 0)), step);
}
