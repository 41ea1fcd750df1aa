// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What friction without memory takes of the slip, and what limits a spring.
INLINE real3 creeping(World w, ContactPoint c, real3 slip, PairLaw law) { return slip; }
INLINE real holding(World w, real pressing) { return pressing; }
