// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 advance_spin(World w, int i, int step) { return (real3)(0); }
INLINE void foresee_spin(World w, int i) {}
