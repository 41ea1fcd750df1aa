// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The integrator has let the last forces act for a while, on a body whose velocity in the middle of that is given.
// Rows of sums: support impulse, work of normal dashpots; field impulse, work of friction; work of gravity, of drag,
// of rolling resistance, of walls. Work of dashpots, friction and rolling is that against the walls' surfaces.
INLINE void add_exactly(global real4* sum, global real4* rest, real4 term) {
  const real4 before = *sum;
  const real4 y = term + *rest;
  const real4 total = before + y;
  const real4 seen = total - before;
  *rest = (before - (total - seen)) + (y - seen);
  *sum = total;
}

INLINE void add_to_row(World w, int i, int row, real4 term) {
  global LedgerSums* s = &w.sums[i];
  add_exactly(&s->sum[row], &s->rest[row], term);
}

INLINE void book_walls(World w, int i, real duration) {
  const int walls = walls_of(w);
  for (int slot = i * walls; slot < (i + 1) * walls; ++slot) {
    global WallSums* s = &w.wall_sums[slot];
    add_exactly(&s->sum[0], &s->rest[0], w.wall_tallies[slot].force * duration);
    add_exactly(&s->sum[1], &s->rest[1], w.wall_tallies[slot].moment * duration);
  }
}

INLINE void book(World w, int i, real duration, real3 velocity) {
  const Tally t = w.tallies[i];
  const real3 field = t.weight.xyz + t.drag.xyz;
  add_to_row(w, i, 0, (real4)(t.support.xyz, along(t.braking.xyz, velocity) - t.support.w) * duration);
  add_to_row(w, i, 1, (real4)(field, along(t.rubbing.xyz, velocity) - t.weight.w) * duration);
  const real gravity = along(t.weight.xyz, velocity), drag = along(t.drag.xyz, velocity);
  add_to_row(w, i, 2, (real4)(gravity, drag, -t.braking.w, t.other.w) * duration);
  book_walls(w, i, duration);
}

INLINE void book_spin(World w, int i, real duration, real3 spin) {
  const Tally t = w.tallies[i];
  add_to_row(w, i, 1, (real4)(0, 0, 0, along(t.twisting.xyz, spin)) * duration);
  add_to_row(w, i, 2, (real4)(0, 0, along(t.resisting.xyz, spin), 0) * duration);
}

// A drag that the integrator applied by itself.
INLINE void book_drag(World w, int i, real duration, real3 acceleration, real3 velocity) {
  const real mass = 1 / w.velocities[i].w;
  const real3 force = acceleration * mass;
  add_to_row(w, i, 1, (real4)(force, 0) * duration);
  add_to_row(w, i, 2, (real4)(0, along(force, velocity), 0, 0) * duration);
}
