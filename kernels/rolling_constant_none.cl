// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 constant_torque(Rolling r, PairLaw law) { return (real3)(0); }
