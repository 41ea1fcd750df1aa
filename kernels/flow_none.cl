// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 flow_at(World w, Position p) { return (real3)(0); }
INLINE real drag_rate(World w, int i) { return 0; }
