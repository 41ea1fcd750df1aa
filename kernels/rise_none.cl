// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Every stiffness is a constant.
typedef struct {
  real factor;
  real root;
  real slope;   // of the normal force by its overlap, over k
  real energy;
} Rise;

INLINE Rise rise_of(real overlap, real radius, PairLaw law) {
  const Rise rise = {1, 1, 1, (real)0.5};
  return rise;
}
