// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/hertz.md: stiffnesses rise with sqrt(R* δ), dashpots with its root.
typedef struct {
  real factor;
  real root;
  real slope;   // of the normal force by its overlap, over k
  real energy;  // of a normal spring, over force times overlap
} Rise;

INLINE Rise rise_of(real overlap, real radius, PairLaw law) {
  Rise rise = {1, 1, 1, (real)0.5};
  if (law.hertz) {
    rise.factor = square_root(radius * overlap);
    rise.root = square_root(rise.factor);
    rise.slope = (real)1.5 * rise.factor;
    rise.energy = (real)2 / (real)5;
  }
  return rise;
}
