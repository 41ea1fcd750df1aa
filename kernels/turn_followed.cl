// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md (integrators.35), (integrators.36): what a spring that has lasted needs to know of the step.
INLINE Turn turn_of(World w, ContactPoint c, PairLaw law, Rise rise, Turnover t, real3 slip, real3 stretching) {
  Turn turn = {c.foresight > 0 && t.since < 0, false, (real3)(0), (real3)(0)};
  if (!turn.followed) return turn;
  const real damping = spring_damping_of(law, c.root_mass, rise);
  turn.earlier = refined_slip(w, c, stretching + stretching - slip, law.spring * rise.factor, damping);
  if (c.other < 0) return turn;
  turn.rolls = true;
  turn.round = half_way_round(w, c);
  return turn;
}
