// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void book(World w, int i, real duration, real3 velocity) {}
INLINE void book_spin(World w, int i, real duration, real3 spin) {}
INLINE void book_drag(World w, int i, real duration, real3 acceleration, real3 velocity) {}
