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
  Push total = {no_sum(), no_sum(), d.box->body_units.x, d.box->body_units.y};
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

INLINE reals inverse_inertia_of(Dense d, Bodies b) {
  return VARIED ? (real)2.5f * b.inverse_mass / (b.radius * b.radius) : (reals)(d.box->body.z);
}

INLINE Vectors spin_after(Dense d, Bodies b, Push p, real kick) {
  const Vectors spun = plus_scaled(b.spin, total_of(p.torque, p.torque_unit), inverse_inertia_of(d, b) * kick);
  return chosen(b.moves, spun, b.spin);
}

INLINE void store_bodies(global real4* records, Bodies b) {
  const Quarter at = {bits_of_phases(b.x), bits_of_phases(b.y), bits_of_phases(b.z), bits_of_phases(b.radius_phase)};
  const Quarter motion = {b.velocity.x, b.velocity.y, b.velocity.z, b.inverse_mass};
  store_own(records, b.first, 0, at);
  store_own(records, b.first, 1, motion);
  const Quarter spin = {b.spin.x, b.spin.y, b.spin.z, 0};
  if (ROTATION) store_own(records, b.first, 2, spin);
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

kernel void dense_step(DENSE_PARAMETERS, global real4* moved, global int* signals, const int step) {
  const Dense d = DENSE_THAT(true);
  if (halts(signals, step, get_global_id(0))) return;
  Bodies b = load_bodies(d, get_global_id(0));
  const Push p = sum_up(d, b, step, signals);
  const real kick = step > 0 ? d.box->time.x : d.box->time.y;
  const Vectors change = scaled(acceleration_of(d, b, p), kick);
  if (ROTATION) b.spin = spin_after(d, b, p, kick);
  global real* own = d.kept + (size_t)b.group * (KEPT * GROUP) + b.lane;
  const real4 drift = d.box->drift;
  b.x = kick_and_move(b.x, &b.velocity.x, own, own + 3 * GROUP, change.x, drift.x, b.moves);
  b.y = kick_and_move(b.y, &b.velocity.y, own + GROUP, own + 4 * GROUP, change.y, drift.y, b.moves);
  b.z = kick_and_move(b.z, &b.velocity.z, own + 2 * GROUP, own + 5 * GROUP, change.z, drift.z, b.moves);
  store_bodies(moved, b);
  if (runs_wild(d, b)) atomic_min(signals_after(signals, step) + ESCAPED_AT, step + 1);
  watch(d, b, step, signals);
}

// What is seen at boundary `step`: nothing moves, velocities are those of the boundary itself.
kernel void dense_report(DENSE_PARAMETERS, global real4* seen, global int* signals, const int step,
                         const int keeps) {
  const Dense d = DENSE_THAT(keeps != 0);
  Bodies b = load_bodies(d, get_global_id(0));
  const Push p = sum_up(d, b, step, signals);
  const real kick = step > 0 ? d.box->time.y : 0;
  b.velocity = chosen(b.moves, plus_scaled(b.velocity, acceleration_of(d, b, p), (reals)(kick)), b.velocity);
  if (ROTATION) b.spin = spin_after(d, b, p, kick);
  store_bodies(seen, b);
}
