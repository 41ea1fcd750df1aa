// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// How contacts stood at the last boundary: their velocities were those of the middle less what led on to the
// prediction.
typedef struct {
  reals overlap, rate, force;
  Vectors slip, gain;  // and what accelerations would have made of it in the step
} Before;

// Spring and dashpot bend together where the limit takes hold of them.
INLINE bool bends(PairLaw law) { return (law.history & REMEMBERS) && !(law.history & LIMIT_ON_SPRING); }

INLINE Swing swing_of(PairLaw law, reals root_mass, int terms) {
  const reals mobility = 1 / (root_mass * root_mass);
  const Swing s = {law.stiffness * mobility, dashpot_of(law, root_mass) * mobility, terms};
  return s;
}

INLINE reals full_force(reals overlap, reals rate, PairLaw law, reals root_mass) {
  return fma((reals)(law.stiffness), overlap, dashpot_of(law, root_mass) * rate);
}

// But for the slip.
INLINE Before pressed_before(Meeting m, PairLaw law, real step) {
  reals middle = -inner(m.middle_velocity, m.normal);
  if (HISTORY && m.rolls && bends(law)) middle += m.closer;
  const reals overlap = fma((reals)(-step), middle, m.overlap);
  Before b;
  b.overlap = overlap > 0 ? overlap : 0;
  b.rate = middle + middle + inner(m.velocity, m.normal);
  b.force = full_force(b.overlap, b.rate, law, m.root_mass);
  b.slip = b.gain = vectors(0, 0, 0);
  return b;
}

// By the normal of the step's middle, where it is asked for a bend.
INLINE Before before_step(Meeting m, PairLaw law, real step) {
  Before b = pressed_before(m, law, step);
  if (!(FRICTION || HISTORY)) return b;
  const Vectors foretold = slip_of(m.velocity, inner(m.velocity, m.normal), m.sweep, m.normal);
  Vectors then = slip_of(m.middle_velocity, inner(m.middle_velocity, m.normal), m.middle_sweep, m.normal);
  if (HISTORY && bends(law)) then = m.stretching;
  b.slip = less(scaled(then, 2), foretold);
  b.gain = less(foretold, b.slip);
  return b;
}
