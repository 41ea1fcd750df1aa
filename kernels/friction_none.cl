// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 friction_force(real3 slip, real pressing, PairLaw law, real root_mass) { return (real3)(0); }
