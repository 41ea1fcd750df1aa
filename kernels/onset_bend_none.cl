// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Without springs nothing of kernels/onset_bend.cl happens.
INLINE real3 rub_of_bend(World w, ContactPoint c, PairLaw law, Strain s, real pressing) { return (real3)(0); }
INLINE real3 rub_of_turnover(ContactPoint c, PairLaw law, Turnover t, real pressing, real step) { return (real3)(0); }
INLINE Turnover followed_turnover(World w, ContactPoint c, PairLaw law, Before b, real last) { return no_turnover(); }
INLINE real3 rub_to_the_end(World w, ContactPoint c, PairLaw law, Before b, real time, real3 spring) {
  return (real3)(0);
}
