// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// (integrators.18): a Hertz contact that begins or ends follows the straight path δ = u τ, along which its spring goes
// with τ^(3/2) and its dashpot with τ^(1/4), τ counted from the touch.

// x^(3/2), or the fourth root of x.
INLINE real grown(real x, bool spring) { return spring ? x * square_root(x) : square_root(square_root(x)); }

// Hurwitz' ζ(−α, θ), by the sum formula from the fifth term on.
INLINE real zeta(real theta, bool spring) {
  const real a = spring ? (real)1.5 : (real)0.25;
  real sum = 0;
  for (int j = 0; j < 4; ++j) sum += grown(theta + j, spring);
  const real m = theta + 4, power = grown(m, spring);
  const real slope = a * power / m, third = a * (a - 1) * (a - 2) * power / (m * m * m);
  return sum - power * m / (a + 1) + power / 2 - slope / 12 + third / 720;
}

// (h/2) f − D h^(1+α) ζ(−α, τ/h) with f = D τ^α: the impulse that is left once the trapezoid rule of all whole steps has
// had its share, and its error with it.
INLINE real with_what_steps_miss(real force, real time, real step, bool spring) {
  const real theta = time / step;
  return step * force * ((real)0.5 - zeta(theta, spring) / grown(theta, spring));
}

// What a contact does that grows to these forces from nothing over a time, or falls from them to nothing.
typedef struct {
  real impulse;  // of both, along the path
  real whole;    // with what steps miss
  real early;    // ∫ τ F dτ/time, τ counted from where there is no force
} Straight;

INLINE Straight straight_of(real spring, real dashpot, real time, real step) {
  Straight s;
  s.impulse = time * (spring / (real)2.5 + dashpot / (real)1.25);
  s.whole = with_what_steps_miss(spring, time, step, true) + with_what_steps_miss(dashpot, time, step, false);
  s.early = time * (spring / (real)3.5 + dashpot / (real)2.25);
  return s;
}

INLINE Begun begun(real rate, real time, real step, PairLaw law, real root_mass, real radius) {
  if (!law.hertz) return linear_begun(rate, time, law, root_mass);
  const Rise rise = rise_of(rate * time, radius, law);
  const Straight s = straight_of(law.stiffness * rise.factor * rate * time, dashpot(law, root_mass) * rise.root * rate,
                                 time, step);
  const real mass = root_mass * root_mass, moment = time * (s.impulse - s.early);
  const Begun b = {s.whole, magnitude(s.impulse), moment, -moment / mass, -s.impulse / mass};
  return b;
}

// Without an end within the step there is nothing to put in the place of what the plain scheme has.
INLINE Ended ended(Before b, real step, PairLaw law, real root_mass, real radius) {
  if (!law.hertz) return linear_ended(b, step, law, root_mass);
  if (!(b.overlap > 0 && -b.rate * step > b.overlap)) {
    const Ended e = {step, (real)0.5 * step * b.force, magnitude(b.force) * step, (real)0.5 * step * step * b.force};
    return e;
  }
  const Rise rise = rise_of(b.overlap, radius, law);
  const real time = b.overlap / -b.rate;
  const Straight s = straight_of(law.stiffness * rise.factor * b.overlap, dashpot(law, root_mass) * rise.root * b.rate,
                                 time, step);
  const Ended e = {time, s.whole, magnitude(s.impulse), (step - time) * s.impulse + time * s.early};
  return e;
}

// No dashpot acts at the touch, so nothing slides there.
INLINE real3 slip_at_touch(real3 slip, PairLaw law) { return law.hertz ? (real3)(0) : slip; }

// Means over the time in contact of k_t (with the slip since the touch, or as it falls) and η_t, over those that a
// beginning comes to or an ending starts from: powers 1/2 and 1/4 of the time.
INLINE real spring_share(PairLaw law, bool begins) {
  return !law.hertz ? (real)1 : begins ? (real)0.8 : (real)2 / (real)3;
}
INLINE real damping_share(PairLaw law) { return law.hertz ? (real)0.8 : (real)1; }
