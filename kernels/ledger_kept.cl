// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Energy and impulse, a particle at a time. What a force takes out of all bodies is minus the sum of its power on
// each, with the velocity that the body has in the middle of its kick; of that no partner needs to be known. What
// springs hold goes half to each of a pair, or whole to the one that moves.

// What contacts that began or ended within the step have done beside their forces, kernels/onset_booked.cl: impulses, and
// works that walls put into them.
typedef struct {
  bool any;
  real3 support, braking, rubbing, twisting, resisting;
  real3 of_one, couple;  // of the wall at hand
  real braked, rubbed, resisted;
} Events;

typedef struct {
  real3 support;
  real3 braking;      // forces of normal dashpots
  real3 rubbing;      // of friction
  real3 twisting;     // torques of friction
  real3 resisting;    // torques of rolling resistance
  real3 of_one;       // force of the wall at hand
  real3 couple;       // rolling couple of the wall at hand
  real braked, rubbed, resisted;  // power that walls put into these
  real driven;                    // power of walls
  real elastic, spring, wound, cohesive;
  Events events;
} Account;

INLINE Account new_account() {
  const real3 none = (real3)(0);
  const Events no_events = {false, none, none, none, none, none, none, none, 0, 0, 0};
  Account a = {none, none, none, none, none, none, none, 0, 0, 0, 0, 0, 0, 0, 0, no_events};
  return a;
}

INLINE real along(real3 force, real3 v) { return force.x * v.x + force.y * v.y + force.z * v.z; }

// A force that is clamped counts as the whole spring and a dashpot that cancels it.
INLINE void enter_normal(Account* a, real share, real energy, real3 dashpot, real3 surface) {
  a->elastic += share * energy;
  a->braking += dashpot;
  a->braked += along(dashpot, surface);
}

INLINE void enter_friction(Account* a, real3 force, real3 torque, real3 surface) {
  a->rubbing += force;
  a->twisting += torque;
  a->rubbed += along(force, surface);
}

INLINE void enter_spring(Account* a, real share, real energy) { a->spring += share * energy; }

INLINE void enter_wound(Account* a, real share, real energy) { a->wound += share * energy; }

INLINE void enter_rolling(Account* a, real3 torque, real3 wall_spin) {
  a->resisting += torque;
  a->couple += torque;
  a->resisted += along(torque, wall_spin);
  a->driven += along(torque, wall_spin);
}

INLINE void enter_cohesion(Account* a, real share, real energy) { a->cohesive += share * energy; }

// Forces of walls and fixed particles, whose share is 1, support; others cancel between two particles.
INLINE void enter_force(Account* a, real share, real3 force, real3 surface) {
  if (share == 1) a->support += force;
  a->of_one += force;
  a->driven += along(force, surface);
}

INLINE void open_wall(Account* a) {
  a->of_one = a->couple = (real3)(0);
  a->events.of_one = a->events.couple = (real3)(0);
}

INLINE real3 moment_about(real3 arm, real3 f) {
  return (real3)(arm.y * f.z - arm.z * f.y, arm.z * f.x - arm.x * f.z, arm.x * f.y - arm.y * f.x);
}

// The arm goes from the wall's reference point to where its surface is touched.
INLINE void close_wall(World w, int slot, Account a, real3 arm) {
  const real3 f = a.of_one, moment = moment_about(arm, f);
  w.wall_tallies[slot].force = (real4)(f, 0);
  w.wall_tallies[slot].moment = (real4)(moment + a.couple, 0);
}

INLINE void close_account(World w, int i, Account a, real3 gravity, real3 drag, int step) {
  const real mass = 1 / w.velocities[i].w;
  Tally t;
  t.support = (real4)(a.support, a.braked);
  t.weight = (real4)(gravity * mass, a.rubbed);
  t.drag = (real4)(drag * mass, a.elastic);
  t.other = (real4)(a.cohesive, a.spring, a.wound, a.driven);
  t.braking = (real4)(a.braking, a.resisted);
  t.rubbing = (real4)(a.rubbing, 0);
  t.twisting = (real4)(a.twisting, 0);
  t.resisting = (real4)(a.resisting, 0);
  w.tallies[i] = t;
  if (step == 0) w.sums[i].start = t.other;
}
