// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 turn_middle(World w, int i, int step) { return (real3)(0); }
