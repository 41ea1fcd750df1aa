// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// (integrators.21): where the Coulomb limit takes hold of spring and dashpot within a step friction bends, and the
// trapezoid rule misses a part of the second order.
#define LEAST_SHARE ((real)1e-3)

typedef struct {
  real3 pull;  // of spring and dashpot against the slip, whatever the limit
  real most;
} Hold;

// Impulse of friction whose pull goes evenly from `first` to `last`, under a limit that goes evenly too.
INLINE real3 rub_between(real3 first, real3 last, real most_first, real most_last, real time) {
  const real size = length_of(first), length = length_of(last), excess = length - most_last;
  const real3 held = size > most_first ? first * (most_first / size) : first;
  const real3 even = (held + last) * ((real)-0.5 * time);
  if (!(excess > 0)) return even;
  const real3 along = last / length;
  const real room = greater_of(most_first - product_of(held, along), 0);
  return even + along * ((real)0.5 * time * excess * excess / (room + excess));
}

// What a dashpot is told less what was true: of the predicted velocity, and of that at the last boundary.
typedef struct {
  real of_now, of_before;
} Foretold;

INLINE Foretold foretold_beside(real step, real mobility, real stiffness, real damping) {
  const real c = (real)0.5 * step * damping * mobility, kappa = (real)0.5 * step * step * stiffness * mobility;
  const Foretold f = {(1 + c) / (1 + c + kappa) - (1 - (real)0.5 * kappa) / (1 + c), ((real)0.5 * kappa - c) / (1 + c)};
  return f;
}

INLINE real sliding_mobility(World w, ContactPoint c) {
  return c.inverse_mass + turning_mobility(w, c.self, c.arm, c.other, c.other_arm);
}

// That of the last boundary in the plane of now, of a contact that has lasted.
INLINE real3 carried_spring(World w, ContactPoint c, PairLaw law) {
  if (c.other < 0) return remembered_spring(c.memory, c.normal, law);
  const real3 spring = c.memory->xyz;
  return spring + product_of(spring, c.normal) * (half_way_round(w, c) - c.normal);
}

// At the last boundary, as dashpots were told. held: the spring of then.
INLINE Hold hold_before(World w, ContactPoint c, PairLaw law, Before b, Rise rise, real3 held) {
  const real step = w.constants->time.x, damping = spring_damping_of(law, c.root_mass, rise);
  const Foretold n = foretold_beside(step, c.inverse_mass, law.stiffness, dashpot(law, c.root_mass));
  const Foretold t = foretold_beside(step, sliding_mobility(w, c), law.spring, damping);
  const real rate = b.rate + n.of_before * b.rate - n.of_now * separating_rate(c);
  const real3 slip = b.slip + t.of_before * b.slip + t.of_now * (b.slip + b.gain);
  const real push = normal_force(b.overlap, -rate, law, c.root_mass, rise);
  const Hold h = {law.spring * held + damping * slip, law.sliding * magnitude(push)};
  return h;
}

// A contact that slides at this boundary and held at the last one, or slid the other way. One that slid all along has
// no room left, but for rounding and what is of higher order.
INLINE real3 rub_of_bend(World w, ContactPoint c, PairLaw law, Strain s, real pressing) {
  const Rise rise = rise_of(c.overlap, c.radius, law);
  const real3 held = carried(c.memory->xyz, s, law);
  const real3 pull = law.spring * (held + s.moved) + spring_damping_of(law, c.root_mass, rise) * s.damped;
  const real length = length_of(pull), excess = length - law.sliding * magnitude(pressing);
  if (!(excess > 0)) return (real3)(0);
  const Hold before = hold_before(w, c, law, before_step(w, c, law), rise, held);
  const real3 along = pull / length;
  const real size = length_of(before.pull);
  const real room = before.most - (product_of(before.pull, along) < 0 ? -size : size);
  if (!(room > LEAST_SHARE * excess)) return (real3)(0);
  return along * ((real)-0.5 * w.constants->time.x * room * excess / (room + excess));
}

// When a force that goes from `first` to `last` in a step passes zero, its second derivative being the same all along.
INLINE real zero_between(real first, real last, real second, real step) {
  const real slope = (last - first) / step - (real)0.5 * step * second;
  const real there = square_root(greater_of(slope * slope - 2 * second * first, 0));
  const real time = 2 * magnitude(first) / (there - (first > 0 ? slope : -slope));
  return time > 0 ? lesser_of(time, step) : 0;
}

// Friction falls to nothing with the limit, and a contact that has gripped anew goes on from the slip of then. last: what
// the normal force comes to.
INLINE Turnover followed_turnover(World w, ContactPoint c, PairLaw law, Before b, real last) {
  const real step = w.constants->time.x, mobility = sliding_mobility(w, c), mass = c.root_mass * c.root_mass;
  const Rise rise = rise_of(c.overlap, c.radius, law);
  const real normal_damping = dashpot(law, c.root_mass), damping = spring_damping_of(law, c.root_mass, rise);
  const real change = law.stiffness * b.rate - normal_damping * b.force / mass;
  const real until = zero_between(b.force, last, -(law.stiffness * b.force + normal_damping * change) / mass, step);
  const Hold before = hold_before(w, c, law, b, rise, carried_spring(w, c, law));
  const real size = length_of(before.pull);
  const real3 held = size > before.most ? before.pull * (before.most / size) : before.pull;
  const real3 growth = law.spring * (b.slip + (real)0.5 * b.gain) + b.gain * (damping / step);
  const real3 rub = rub_between(held, held + until * growth, before.most, 0, until);
  const real3 drift = b.gain / step + mobility * held;  // by all but this friction
  Turnover t = no_turnover();
  t.followed = true;
  t.since = step - until;
  t.slip = b.slip + until * drift + mobility * rub;
  t.now = (1 - (real)0.5 * law.spring * mobility * t.since * t.since) * t.slip + t.since * drift;
  t.way = t.now * t.since;
  t.rub = rub + ((real)0.5 * step) * held;
  return t;
}

// With friction at the boundary, which is known once the normal force is.
INLINE real3 rub_of_turnover(ContactPoint c, PairLaw law, Turnover t, real pressing, real step) {
  const real damping = spring_damping_of(law, c.root_mass, rise_of(c.overlap, c.radius, law));
  const real3 spring = t.way - (damping / law.spring) * t.slip;
  const Grip g = gripped(spring, damping * t.now, law.spring, law.sliding * magnitude(pressing), law);
  return t.rub - ((real)0.5 * (t.since - step)) * g.force;
}

// Of a contact that ends. In two parts where the normal force passes zero before.
INLINE real3 rub_to_the_end(World w, ContactPoint c, PairLaw law, Before b, real time, real3 spring) {
  const real mass = c.root_mass * c.root_mass, normal_damping = dashpot(law, c.root_mass), share = law.sliding;
  const Rise rise = rise_of(b.overlap, c.radius, law);
  const real damping = spring_damping_of(law, c.root_mass, rise);
  const Flow f = flow_of(b.overlap, b.rate, time, law.stiffness, normal_damping, mass);
  const real first = greater_of(b.force, law.lowest);
  const real last = normal_force(b.overlap + time * b.rate + f.way, -b.rate - f.gain, law, c.root_mass, rise);
  const real3 pull = law.spring * spring + damping * b.slip;
  const real3 growth = law.spring * b.slip + b.gain * (damping / w.constants->time.x);
  if (!(first > 0 && last < 0))
    return rub_between(pull, pull + time * growth, share * magnitude(first), share * magnitude(last), time);
  const real change = law.stiffness * b.rate - normal_damping * first / mass;
  const real until = parting_time(first, change, time, law.stiffness, normal_damping, mass), rest = time - until;
  const real3 rub = rub_between(pull, pull + until * growth, share * first, 0, until);
  const real3 slip = b.slip + sliding_mobility(w, c) * rub;
  return rub + rub_between((real3)(0), (law.spring * rest) * slip, 0, -share * last, rest);
}
