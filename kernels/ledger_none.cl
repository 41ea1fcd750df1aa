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
INLINE void enter_normal(Account* a, real share, real power, real energy) {}
INLINE void enter_friction(Account* a, real share, real power) {}
INLINE void enter_spring(Account* a, real share, real energy) {}
INLINE void enter_cohesion(Account* a, real share, real energy) {}
INLINE void enter_force(Account* a, real share, real3 force) {}
INLINE void close_account(World w, int i, Account a, real3 gravity, real3 drag) {}
INLINE void book(World w, int i, real duration, real3 velocity) {}
INLINE void book_drag(World w, int i, real duration, real3 acceleration, real3 velocity) {}
