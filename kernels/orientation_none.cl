// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Nobody asks how bodies lie.
INLINE void turn_over(World w, int i, real3 spin) {}
INLINE void report_orientation(World w, int i, global real4* seen, int entry) {}
