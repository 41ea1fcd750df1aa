// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/rotation.md: dω/dt = τ/I, I = 2/5 m r²; the torque of a force at the end of an arm along the normal.
typedef struct {
  real3 torque;
} Turning;

INLINE Turning no_turning() {
  Turning t = {(real3)(0)};
  return t;
}

// Written out, so that mirrored arguments give mirrored bits on every device.
INLINE real3 across(real3 a, real3 b) {
  return (real3)(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

INLINE real torque_arm(real radius, real overlap, PairLaw law) {
  return law.history & ARM_SHORTENED ? radius - (real)0.5 * overlap : radius;
}

INLINE real3 spin_of(World w, int i) { return w.spins[i].xyz; }
INLINE real3 middle_spin_of(World w, int i) { return w.spin_middles[i].xyz; }
INLINE real3 settled_spin(World w, int i) {
  return w.spin_middles[i].xyz + w.angular_accelerations[i].xyz * w.constants->time.y;
}

// v_rel = v2 − v1 − (a1 ω1 + a2 ω2) × n: the last term.
INLINE real3 rolling_of_pair(World w, int i, real arm_i, int j, real arm_j, real3 normal) {
  return across(arm_i * w.spins[i].xyz + arm_j * w.spins[j].xyz, normal);
}

// The same with other spins; a wall, whose j is below 0, has none.
INLINE real3 rolling_in(const global real4* spins, int i, real arm_i, int j, real arm_j, real3 normal) {
  const real3 own = arm_i * spins[i].xyz;
  return across(j < 0 ? own : own + arm_j * spins[j].xyz, normal);
}

// What turning adds to the inverse mass that a force along the slip has to move.
INLINE real turning_mobility(World w, int i, real arm_i, int j, real arm_j) {
  const real own = arm_i * arm_i * w.spins[i].w;
  return j < 0 ? own : own + arm_j * arm_j * w.spins[j].w;
}

INLINE real inverse_inertia_of(World w, int i) { return w.spins[i].w; }

INLINE real3 rolling_on_wall(World w, int i, real arm, real3 normal) {
  return across(arm * w.spins[i].xyz, normal);
}

// The second body is touched at −a n from its centre.
INLINE real3 torque_of(real3 rubbing, real arm, real3 normal) { return arm * across(rubbing, normal); }

INLINE void turn_body(Turning* t, real3 torque) { t->torque += torque; }

INLINE void close_turning(World w, int i, Turning t) {
  w.angular_accelerations[i] = (real4)(t.torque * w.spins[i].w, 0);
}

INLINE void spin_up(World w, int i, real duration) {
  Motion m = motion_in(w.spins, w.spin_rests, i);
  const real3 before = m.velocity;
  kick(&m, w.angular_accelerations[i].xyz * duration);
  keep_motion(w.spins, w.spin_rests, i, m);
  book_spin(w, i, duration, (before + m.velocity) * (real)0.5);
}
