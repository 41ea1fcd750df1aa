// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 gravity_at(World w, Position p, int step) { return (real3)(0); }
