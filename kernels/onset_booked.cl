// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// (integrators.19): what contacts that began or ended have done beside the forces is booked with the mean of the
// velocities before and after it, as soon as the body's forces are known, and with them the velocity that it comes on.
INLINE void enter_event(Account* account, ContactPoint c, real3 normal, real3 rubbing, real3 torque, real3 rolled) {
  Events* e = &account->events;
  e->any = true;
  e->braking += normal;
  e->rubbing += rubbing;
  e->twisting += torque;
  e->resisting += rolled;
  e->braked += along(normal, c.surface);
  e->rubbed += along(rubbing, c.surface);
  e->resisted += along(rolled, c.wall_spin);
  if (c.share == 1) e->support += normal + rubbing;
  e->of_one += normal + rubbing;
  e->couple += rolled;
}

INLINE void book_wall_events(World w, int slot, Account account, real3 arm) {
  const Events e = account.events;
  if (!e.any) return;
  global WallSums* s = &w.wall_sums[slot];
  add_exactly(&s->sum[0], &s->rest[0], (real4)(e.of_one, 0));
  add_exactly(&s->sum[1], &s->rest[1], (real4)(moment_about(arm, e.of_one) + e.couple, 0));
}

INLINE void book_events(World w, int i, Account account) {
  const Events e = account.events;
  if (!e.any) return;
  const global real4* change = w.corrections + CORRECTION_WORDS * i;
  const real3 settled = w.middles[i].xyz + w.accelerations[i].xyz * w.constants->time.y;
  const real3 velocity = settled + (real)0.5 * change[0].xyz;
  const real3 spin = settled_spin(w, i) + (real)0.5 * change[2].xyz;
  add_to_row(w, i, 0, (real4)(e.support, along(e.braking, velocity) - e.braked));
  add_to_row(w, i, 1, (real4)(0, 0, 0, along(e.rubbing, velocity) + along(e.twisting, spin) - e.rubbed));
  add_to_row(w, i, 2, (real4)(0, 0, along(e.resisting, spin) - e.resisted, e.braked + e.rubbed + e.resisted));
}
