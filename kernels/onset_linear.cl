// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The normal motion of a linear contact in the step in which it begins or ends, followed exactly.
typedef struct {
  real impulse;    // of the normal force
  real pressed;    // its magnitude, as friction has it
  real moment;     // of the force, over what is left of the step
  real way, gain;  // what it has changed of the overlap and its rate
} Begun;

typedef struct {
  real time, impulse, pressed, moment;
} Ended;

// How a contact stood at the last boundary: its velocities were those of the middle less what led on to the prediction.
typedef struct {
  real overlap, rate;
  real3 slip, gain;  // and what accelerations would have made of it in the step
  real force;
} Before;

// Whatever the law, a pull too.
INLINE real full_force(real overlap, real separating, PairLaw law, real root_mass, Rise rise) {
  return law.stiffness * rise.factor * overlap - dashpot(law, root_mass) * rise.root * separating;
}

// Its impulse, were it never to change its sign, by Simpson's rule.
INLINE real pressing_impulse(Before b, real time, Flow end, PairLaw law, real root_mass) {
  const real mass = root_mass * root_mass;
  const Rise rise = rise_of(b.overlap, 0, law);
  const Flow middle = flow_of(b.overlap, b.rate, (real)0.5 * time, law.stiffness, dashpot(law, root_mass), mass);
  const real halfway = b.overlap + (real)0.5 * time * b.rate + middle.way;
  const real second = full_force(halfway, -b.rate - middle.gain, law, root_mass, rise);
  const real third = full_force(b.overlap + time * b.rate + end.way, -b.rate - end.gain, law, root_mass, rise);
  return (magnitude(b.force) + 4 * magnitude(second) + magnitude(third)) * (time / 6);
}

// Until there is no overlap left, or where the law never pulls no force, which swings as the overlap does.
INLINE real time_left(Before b, real step, PairLaw law, real damping, real mass) {
  const real apart = parting_time(b.overlap, b.rate, step, law.stiffness, damping, mass);
  if (law.lowest < 0) return apart;
  const real change = law.stiffness * b.rate - damping * b.force / mass;
  return lesser_of(apart, parting_time(b.force, change, step, law.stiffness, damping, mass));
}

INLINE Begun linear_begun(real rate, real time, PairLaw law, real root_mass) {
  const real mass = root_mass * root_mass;
  const Flow f = flow_of(0, rate, time, law.stiffness, dashpot(law, root_mass), mass);
  Begun b = {-mass * f.gain, 0, -mass * f.way, f.way, f.gain};
  if (law.lowest == 0) b.impulse = greater_of(b.impulse, 0);
  b.pressed = magnitude(b.impulse);
  return b;
}

INLINE Ended linear_ended(Before b, real step, PairLaw law, real root_mass) {
  const real mass = root_mass * root_mass;
  Ended e;
  e.time = time_left(b, step, law, dashpot(law, root_mass), mass);
  const Flow f = flow_of(b.overlap, b.rate, e.time, law.stiffness, dashpot(law, root_mass), mass);
  e.impulse = -mass * f.gain;
  e.moment = -mass * f.way + (step - e.time) * e.impulse;
  e.pressed = pressing_impulse(b, e.time, f, law, root_mass);
  return e;
}
