// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing turns.
typedef struct {
  char nothing;
} Turning;

INLINE Turning no_turning() {
  Turning t = {0};
  return t;
}
INLINE real torque_arm(real radius, real overlap, PairLaw law) { return 0; }
INLINE real3 spin_of(World w, int i) { return (real3)(0); }
INLINE real3 middle_spin_of(World w, int i) { return (real3)(0); }
INLINE real3 settled_spin(World w, int i) { return (real3)(0); }
INLINE real3 rolling_of_pair(World w, int i, real arm_i, int j, real arm_j, real3 normal) { return (real3)(0); }
INLINE real3 rolling_in(const global real4* spins, int i, real arm_i, int j, real arm_j, real3 normal) {
  return (real3)(0);
}
INLINE real turning_mobility(World w, int i, real arm_i, int j, real arm_j) { return 0; }
INLINE real inverse_inertia_of(World w, int i) { return 0; }
INLINE real3 rolling_on_wall(World w, int i, real arm, real3 normal) { return (real3)(0); }
INLINE real3 torque_of(real3 rubbing, real arm, real3 normal) { return (real3)(0); }
INLINE void turn_body(Turning* t, real3 torque) {}
INLINE void close_turning(World w, int i, Turning t) {}
INLINE void spin_up(World w, int i, real duration) {}
