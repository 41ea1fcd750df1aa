// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The normal motion of m δ'' + η δ' + k δ = 0 from an overlap and its rate, by its power series, for many contacts at
// once. All take as many terms as the worst of the scene's needs: the two sides of a contact stand among different
// ones, and must come to the same.
#define PARTING_END (PHASE_BITS == 32 ? (real)0x1p-13 : (real)0x1p-30)

typedef struct {
  reals way;   // δ − δ_0 − u_0 t
  reals gain;  // u − u_0
} Flow;

// Over the effective mass.
typedef struct {
  reals stiffness, damping;
  int terms;
} Swing;

#define FLOW_TERMS 25
constant double one_over[FLOW_TERMS] = {0,        1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,  1.0 / 8,
                                        1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15, 1.0 / 16, 1.0 / 17,
                                        1.0 / 18, 1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23, 1.0 / 24};

INLINE Flow flow_of(reals overlap, reals rate, reals time, Swing swing) {
  const reals p = swing.damping * time, q = swing.stiffness * time * time;
  reals before = overlap, now = rate * time, gain = 0;
  Flow f = {0, 0};
  for (int n = 2; n < swing.terms; ++n) {
    const real share = -(real)one_over[n], smaller = share * (real)one_over[n - 1];
    const reals next = fma(now, p * share, before * (q * smaller));
    f.way += next;
    gain = fma(next, (reals)((real)n), gain);
    before = now;
    now = next;
  }
  f.gain = time > 0 ? gain / time : 0;
  return f;
}

// When a contact that parts has no overlap left, by Newton's steps from the motion at even acceleration; `longest`
// where it never comes to that.
INLINE reals parting_time(reals overlap, reals rate, real longest, Swing swing) {
  const flags some = overlap > 0;
  flags comes = some & (rate < 0);
  const reals pull = fma(swing.stiffness, overlap, swing.damping * rate);  // over the mass, against the overlap
  const reals swiftness = fma(rate, rate, 2 * pull * overlap);
  const reals guess = 2 * overlap / (roots_of(swiftness > 0 ? swiftness : 0) - rate);
  reals time = (comes & (guess < longest)) ? guess : (reals)(longest);
  flags seeks = comes;
  for (int k = 0; k < 6; ++k) {
    const Flow f = flow_of(overlap, rate, time, swing);
    const reals speed = rate + f.gain;
    comes = comes & (speed < 0);
    seeks = seeks & comes;
    const reals next = time - (overlap + rate * time + f.way) / speed;
    const reals within = next < 0 ? 0 : (next > longest ? (reals)(longest) : next);
    const reals change = magnitudes(within - time);
    time = seeks ? within : time;
    seeks = seeks & (change > PARTING_END * time);
    if (!any_of(seeks)) break;
  }
  return some ? (comes ? time : (reals)(longest)) : 0;
}
