// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Springs that slide at the end of a step through which they have lasted: (integrators.36), (integrators.21).

// Of a force that has turned since the step's start and 1/`inverse` long now: a cut in either half of the step counted twice,
// less the one at its end. Multiplied out, over that length, roots and divisions being dear.
INLINE Vectors cut_along(Vectors before, Vectors trial, flags lasts, reals inverse, reals limit) {
  const reals share = limit * inverse, unit = inverse * inverse;
  const reals square = inner(before, before) * unit, product = inner(before, trial) * unit;
  const reals middle = (real)0.25f * square + (real)0.5f * product + (real)0.25f;
  const reals reached = quick_roots_of(middle), halfway = (real)0.5f * (quick_roots_of(square) + share);
  const reals beyond = (lasts & (reached > halfway)) ? reached - halfway : 0;
  const reals second = quick_roots_of(fma(middle, beyond * beyond, middle) - reached * beyond * (1 + product));
  const reals onward = beyond > 0 ? 2 * reached - beyond - second : 1;
  const reals way = fma(onward, onward, beyond * (beyond * square - 2 * onward * product));
  const reals scale = share * inverse_roots_of(way > 0 ? way : 1);
  return plus_scaled(scaled(trial, scale * onward), before, -scale * beyond);
}

// Contacts that slide at this boundary and held at the last one, or slid the other way. Those that slid all along have
// no room left, but for rounding and what is of higher order. The step has made `pull`, 1/`inverse` long, of `held`.
INLINE void bend(Push* total, Meeting m, flags bent, Vectors held, Vectors slip, Vectors pull, reals inverse, reals limit,
                 PairLaw law, real step) {
  if (!any_of(bent)) return;
  Before b = pressed_before(m, law, step);
  b.slip = plus_scaled(scaled(m.stretching, 2), slip, (reals)(-1));
  b.gain = less(slip, b.slip);
  const Hold before = hold_before(m, b, held, law, step);
  const reals towards = inner(before.pull, pull), square = inner(before.pull, before.pull);
  const reals excess = fma(inner(pull, pull), inverse, -limit);
  const reals least = before.most - LEAST_SHARE * excess;
  bent = bent & ((towards < 0) | ((least > 0) & (least * least > square)));  // mostly settles it, without a root
  if (!any_of(bent)) return;
  const reals size = quick_roots_of(square);
  const reals room = before.most - (towards < 0 ? -size : size);
  bent = bent & (room > LEAST_SHARE * excess);
  if (!any_of(bent)) return;
  const reals share = (real)-0.5f * step * room * (excess * inverses_of(room + excess) * inverse);
  add_rub(total, m, chosen(bent, scaled(pull, share), vectors(0, 0, 0)), step);
}

// As gripping_force(); `held` is what the spring was before the slip of the step's middle stretched it.
INLINE Vectors gripping_along(Push* total, Vectors* spring, Vectors held, Vectors slip, Meeting m, reals limit,
                              PairLaw law, real step) {
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  const reals damping = spring_dashpot_of(law, m.root_mass) * m.foreseen_slip;
  const Vectors trial = *spring, damped = scaled(slip, damping), pull = scaled(trial, (reals)(law.spring));
  const Vectors sum = plus_scaled(damped, trial, (reals)(law.spring)), limited = alone ? pull : sum;
  const reals square = inner(limited, limited);
  const flags slides = square > limit * limit;
  if (!any_of(slides)) return sum;
  const reals inverse = inverse_roots_of(slides ? square : 1);
  if (!alone) bend(total, m, slides & m.lasts, held, slip, limited, inverse, limit, law, step);
  const Vectors earlier = plus_scaled(m.stretching, slip, (reals)(-0.5f));
  const Vectors before = plus_scaled(scaled(held, (reals)(law.spring)), earlier, alone ? (reals)(0) : 2 * damping);
  const Vectors cut = cut_along(before, limited, m.lasts, inverse, limit);
  *spring = chosen(slides, scaled(alone ? cut : less(cut, damped), (reals)(1 / law.spring)), trial);
  return chosen(slides, cut, sum);
}
