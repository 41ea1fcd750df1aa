// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Energy and impulse, a particle at a time: a pair's energy goes half to each, or whole to the one that moves.
typedef struct {
  real3 support;
  real normal_power;
  real tangential_power;
  real elastic;
  real cohesive;
} Account;

INLINE Account new_account() {
  Account a = {(real3)(0), 0, 0, 0, 0};
  return a;
}

INLINE void enter_normal(Account* a, real share, real power, real energy) {
  a->normal_power += share * power;
  a->elastic += share * energy;
}

INLINE void enter_friction(Account* a, real share, real power) { a->tangential_power += share * power; }

INLINE void enter_spring(Account* a, real share, real energy) { a->elastic += share * energy; }

INLINE void enter_cohesion(Account* a, real share, real energy) { a->cohesive += share * energy; }

// Forces of walls and fixed particles, whose share is 1, support; others cancel between two particles.
INLINE void enter_force(Account* a, real share, real3 force) {
  if (share == 1) a->support += force;
}

INLINE void close_account(World w, int i, Account a, real3 gravity, real3 drag) {
  const real mass = 1 / w.velocities[i].w;
  Tally t;
  t.support = (real4)(a.support, a.normal_power);
  t.weight = (real4)(gravity * mass, a.tangential_power);
  t.drag = (real4)(drag * mass, a.elastic);
  t.other = (real4)(a.cohesive, 0, 0, 0);
  w.tallies[i] = t;
}

INLINE void add_exactly(global LedgerSums* s, int row, real4 term) {
  const real4 before = s->sum[row];
  const real4 y = term + s->rest[row];
  const real4 sum = before + y;
  const real4 seen = sum - before;
  s->rest[row] = (before - (sum - seen)) + (y - seen);
  s->sum[row] = sum;
}

INLINE real along(real4 force, real3 v) { return force.x * v.x + force.y * v.y + force.z * v.z; }

// The integrator has let the last forces act for `duration` on a body that drifts with `velocity`.
INLINE void book(World w, int i, real duration, real3 velocity) {
  const Tally t = w.tallies[i];
  const real4 field = t.weight + t.drag;
  add_exactly(&w.sums[i], 0, t.support * duration);
  add_exactly(&w.sums[i], 1, (real4)(field.xyz, t.weight.w) * duration);
  add_exactly(&w.sums[i], 2, (real4)(along(t.weight, velocity), along(t.drag, velocity), 0, 0) * duration);
}

// A drag that the integrator applied by itself.
INLINE void book_drag(World w, int i, real duration, real3 acceleration, real3 velocity) {
  const real mass = 1 / w.velocities[i].w;
  const real4 force = (real4)(acceleration * mass, 0);
  add_exactly(&w.sums[i], 1, force * duration);
  add_exactly(&w.sums[i], 2, (real4)(0, along(force, velocity), 0, 0) * duration);
}
