// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// No ledger was asked for.
typedef struct {
  char nothing;
} Account;

INLINE Account new_account() {
  Account a = {0};
  return a;
}
INLINE void enter_normal(Account* a, real share, real energy, real3 dashpot, real3 surface) {}
INLINE void enter_friction(Account* a, real3 force, real3 torque, real3 surface) {}
INLINE void enter_spring(Account* a, real share, real energy) {}
INLINE void enter_wound(Account* a, real share, real energy) {}
INLINE void enter_rolling(Account* a, real3 torque, real3 wall_spin) {}
INLINE void enter_cohesion(Account* a, real share, real energy) {}
INLINE void enter_force(Account* a, real share, real3 force, real3 surface) {}
INLINE void open_wall(Account* a) {}
INLINE void close_wall(World w, int slot, Account a, real3 arm) {}
INLINE void close_account(World w, int i, Account a, real3 gravity, real3 drag, int step) {}
