// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A step is one launch: forces at a boundary, the kick through it, the move to the next. Two copies of the records
// take turns, and two sets of signals: no kernel reads what it writes.
#define SIGNALS 4

INLINE const global int* signals_before(const global int* signals, int step) { return signals + (step & 1) * SIGNALS; }
INLINE global int* signals_after(global int* signals, int step) { return signals + (~step & 1) * SIGNALS; }

// Whether the step that begins at boundary `step` must not be taken. The word is passed on.
INLINE bool halts(global int* signals, int step, int item) {
  const global int* before = signals_before(signals, step);
  const int stale = before[STALE_AT], escaped = before[ESCAPED_AT], overlapped = before[OVERLAPPED_AT];
  if (stale > step && escaped > step && overlapped >= step) return false;
  if (item == 0) {
    global int* after = signals_after(signals, step);
    after[STALE_AT] = stale;
    after[ESCAPED_AT] = escaped;
    after[OVERLAPPED_AT] = overlapped;
  }
  return true;
}

// Forces and torques at boundary `step`. Springs are stretched but before the first step.
INLINE Push sum_up(Dense d, Bodies b, int step, global int* signals) {
  const real duration = step > 0 ? d.box->time.x : 0;
  Push total = {no_sum(), no_sum(), no_sum(), no_sum(), no_sum(), false, d.box->body_units.x, d.box->body_units.y};
  int heard = meet_pairs(d, &total, b, duration);
  if (PLANES) heard |= meet_walls(d, &total, b, duration);
  if (heard & OVERLAPS_TOO_MUCH) atomic_min(signals_after(signals, step) + OVERLAPPED_AT, step);
  if (heard & ROWS_ARE_SHORT) atomic_min(signals_after(signals, step) + STALE_AT, step + 1);
  return total;
}

INLINE Vectors acceleration_of(Dense d, Bodies b, Push p) {
  const real4 g = d.box->gravity;
  return plus_scaled(vectors(g.x, g.y, g.z), total_of(p.force, p.force_unit), b.inverse_mass);
}

INLINE Vectors spin_after(Dense d, Bodies b, Push p, real kick) {
  const reals inverse = inverse_inertia_of(d, b.inverse_mass, b.radius);
  Vectors spun = plus_scaled(b.spin, total_of(p.torque, p.torque_unit), inverse * kick);
  if (CORRECTED) spun = plus_scaled(spun, total_of(p.twist, p.torque_unit), inverse * d.box->time.x);
  return chosen(b.moves, spun, b.spin);
}

// What contacts that began or ended give besides their forces, in m/s: at once, and for the length of a step.
INLINE Vectors kick_of(Dense d, Bodies b, Push p) {
  return scaled(total_of(p.impulse, p.force_unit), b.inverse_mass * d.box->time.x);
}

INLINE Vectors shift_of(Dense d, Bodies b, Push p) {
  const Vectors shift = scaled(total_of(p.moment, p.force_unit), b.inverse_mass * d.box->time.x);
  return chosen(b.moves, shift, vectors(0, 0, 0));
}

INLINE void shift_bodies(Dense d, Bodies* b, Push p, global real* own) {
  if (!p.corrected) return;
  const Vectors shift = shift_of(d, *b, p);
  const real4 drift = d.box->drift;
  b->x = displaced(b->x, own, shift.x * drift.x);
  b->y = displaced(b->y, own + GROUP, shift.y * drift.y);
  b->z = displaced(b->z, own + 2 * GROUP, shift.z * drift.z);
}

INLINE void shift_for_sight(Dense d, Bodies* b, Push p) {
  const Vectors shift = shift_of(d, *b, p);
  const real4 drift = d.box->drift;
  b->x = displaced_roughly(b->x, shift.x * drift.x);
  b->y = displaced_roughly(b->y, shift.y * drift.y);
  b->z = displaced_roughly(b->z, shift.z * drift.z);
}

INLINE void step_from_middle(Bodies* b) {
  b->velocity = b->middle_velocity;
  b->spin = b->middle_spin;
}

// Velocities of the middle of the step that begins become those that forces at its end take.
INLINE void predict(Dense d, Bodies* b, Vectors acceleration, Push p) {
  const real half_step = d.box->time.y;
  b->middle_velocity = b->velocity;
  b->velocity = chosen(b->moves, plus_scaled(b->velocity, acceleration, (reals)(half_step)), b->velocity);
  if (!ROTATION) return;
  b->middle_spin = b->spin;
  const reals inverse = inverse_inertia_of(d, b->inverse_mass, b->radius);
  b->spin = chosen(b->moves, plus_scaled(b->spin, total_of(p.torque, p.torque_unit), inverse * half_step), b->spin);
}

INLINE void store_bodies(global real4* records, Bodies b) {
  const Quarter at = {bits_of_phases(b.x), bits_of_phases(b.y), bits_of_phases(b.z), bits_of_phases(b.radius_phase)};
  const bool turns = MIDDLE_SPIN_PACKED;
  const Quarter motion = {b.velocity.x, b.velocity.y, b.velocity.z, turns ? b.middle_spin.x : b.inverse_mass};
  store_own(records, b.first, 0, at);
  store_own(records, b.first, 1, motion);
  const Quarter spin = {b.spin.x, b.spin.y, b.spin.z, turns ? b.middle_spin.y : 0};
  if (ROTATION) store_own(records, b.first, 2, spin);
  const Quarter middle = {b.middle_velocity.x, b.middle_velocity.y, b.middle_velocity.z, turns ? b.middle_spin.z : 0};
  if (PREDICTED) store_own(records, b.first, MIDDLE, middle);
  const Quarter middle_spin = {b.middle_spin.x, b.middle_spin.y, b.middle_spin.z, 0};
  if (MIDDLE_SPIN_APART) store_own(records, b.first, MIDDLE + 1, middle_spin);
}

// Signals what must be heard of before the step after the next boundary.
INLINE void watch(Dense d, Bodies b, int step, global int* signals) {
  const global phase* then = d.built_at + (size_t)b.group * (3 * GROUP) + b.lane;
  const real4 m = d.box->metre;
  const Vectors moved = vectors(to_reals(b.x - load_phases(then)) * m.x, to_reals(b.y - load_phases(then + GROUP)) * m.y,
                                to_reals(b.z - load_phases(then + 2 * GROUP)) * m.z);
  bool stale = any_of(inner(moved, moved) > d.box->limits.y);
  if (HISTORY) stale |= any_of(inner(b.velocity, b.velocity) > d.box->limits.w);
  if (stale) atomic_min(signals_after(signals, step) + STALE_AT, step + 1);
  if (escapes(d, b, stale)) atomic_min(signals_after(signals, step) + ESCAPED_AT, step + 1);
}

// Farther in a step than its radius or an eighth of a cell, or no number: dense_failure.cpp.
INLINE bool runs_wild(Dense d, Bodies b) {
  const reals square = inner(b.velocity, b.velocity);
  flags calm = square < d.box->time.z;
  if (VARIED) calm &= square * d.box->time.w <= b.radius * b.radius;
  return any_of((calm ? (reals)(0) : (reals)(1)) > 0);
}

INLINE void take_step(Dense d, int item, global real4* moved, global int* signals, int step) {
  Bodies b = load_bodies(d, item);
  const Push p = sum_up(d, b, step, signals);
  const real kick = step > 0 ? d.box->time.x : d.box->time.y;
  const Vectors acceleration = acceleration_of(d, b, p);
  Vectors change = scaled(acceleration, kick);
  if (PREDICTED) step_from_middle(&b);
  if (CORRECTED) change = plus_scaled(change, kick_of(d, b, p), (reals)(1));
  if (ROTATION) b.spin = spin_after(d, b, p, kick);
  global real* own = d.kept + (size_t)b.group * (KEPT * GROUP) + b.lane;
  if (CORRECTED) shift_bodies(d, &b, p, own);
  const real4 drift = d.box->drift;
  b.x = kick_and_move(b.x, &b.velocity.x, own, own + 3 * GROUP, change.x, drift.x, b.moves);
  b.y = kick_and_move(b.y, &b.velocity.y, own + GROUP, own + 4 * GROUP, change.y, drift.y, b.moves);
  b.z = kick_and_move(b.z, &b.velocity.z, own + 2 * GROUP, own + 5 * GROUP, change.z, drift.z, b.moves);
  if (PREDICTED) predict(d, &b, acceleration, p);
  store_bodies(moved, b);
  if (runs_wild(d, b)) atomic_min(signals_after(signals, step) + ESCAPED_AT, step + 1);
  watch(d, b, step, signals);
}

// A stretch is that many of `items`, what one has of a group. claims, whose: dense_shares.cl
kernel void dense_step(DENSE_PARAMETERS, global real4* moved, global int* signals, global int* claims,
                       global int* whose, const int shares, const int stretch, const int items, const int step) {
  if (halts(signals, step, get_global_id(0))) return;
  const Dense d = DENSE_THAT(true);
  open_claims_of_next(claims, step, shares);
  const int first = claimed_stretch(claims, whose, step, shares) * stretch;
  for (int item = first; item < min(first + stretch, items); ++item) take_step(d, item, moved, signals, step);
}

// What is seen at boundary `step`: nothing moves, velocities are those of the boundary itself.
kernel void dense_report(DENSE_PARAMETERS, global real4* seen, global int* signals, const int step,
                         const int keeps) {
  const Dense d = DENSE_THAT(keeps != 0);
  Bodies b = load_bodies(d, get_global_id(0));
  const Push p = sum_up(d, b, step, signals);
  const real kick = step > 0 ? d.box->time.y : 0;
  if (PREDICTED) step_from_middle(&b);
  Vectors velocity = plus_scaled(b.velocity, acceleration_of(d, b, p), (reals)(kick));
  if (CORRECTED) velocity = plus_scaled(velocity, kick_of(d, b, p), (reals)(1));
  b.velocity = chosen(b.moves, velocity, b.velocity);
  if (ROTATION) b.spin = spin_after(d, b, p, kick);
  if (CORRECTED) shift_for_sight(d, &b, p);
  store_bodies(seen, b);
}
