// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#define ROLLING_WORDS 0

INLINE real3 winding_on_wall(real3 spin, real radius, real overlap, PairLaw law) { return spin; }
INLINE real3 held_torque(Rolling r, PairLaw law) { return (real3)(0); }
INLINE real3 spring_torque(Rolling r, PairLaw law, Account* account) { return (real3)(0); }
