// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A core's share of a step. A runtime hands work-items to cores as they come, and a core that is given what another
// one had in the step before must fetch all of it from there, about a sixth of a bed's time on two cores. So a work-item has
// no bodies of its own: it claims a stretch of them, from the share of its core while something is left in it, and
// then from others'. A core is known by where its stack lies. That is a hint: any answer leads to the same bits.
//
// claims: how many stretches of each share are taken, a line of cache each, in even steps and in odd ones. There are as
// many work-items as stretches, so each finds one. whose: the core that each share belongs to, once there is one.
#define LINE 16

INLINE int own_share(global int* whose, int shares) {
  int somewhere;
  const int core = (int)((size_t)&somewhere >> 16) | 1;
  for (int share = 0; share < shares; ++share) {
    const int owner = atomic_cmpxchg(whose + share, 0, core);
    if (owner == 0 || owner == core) return share;
  }
  return 0;
}

INLINE int claimed_stretch(global int* claims, global int* whose, int step, int shares) {
  const int stretches = get_global_size(0);
  global int* taken = claims + (step & 1) * LINE * shares;
  const int own = own_share(whose, shares);
  for (int k = 0; k < shares; ++k) {
    const int share = (own + k) % shares;
    const int first = stretches * share / shares, end = stretches * (share + 1) / shares;
    const int at = first + atomic_inc(taken + share * LINE);
    if (at < end) return at;
  }
  return stretches;
}

// Nobody looks at those of the next step yet.
INLINE void open_claims_of_next(global int* claims, int step, int shares) {
  if (get_global_id(0) != 0) return;
  for (int share = 0; share < shares; ++share) claims[((~step & 1) * shares + share) * LINE] = 0;
}
