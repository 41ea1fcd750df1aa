// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void report_spin(World w, int i, int step, global real4* seen, int entry) {}
