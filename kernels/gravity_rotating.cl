// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The host works out where the field points at every step, in double.
INLINE real3 gravity_at(World w, Position p, int step) { return w.gravity_table[step - w.table_origin].xyz; }
