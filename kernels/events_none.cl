// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Without corrections, or without a ledger, there is nothing to book beside the forces.
INLINE void book_wall_events(World w, int slot, Account account, real3 arm) {}
INLINE void book_events(World w, int i, Account account) {}
