// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing resists rolling.
INLINE real3 resist_rolling(Turning* turning, Rolling r, PairLaw law, Account* account) { return (real3)(0); }
INLINE real3 rolling_to_the_end(Rolling r, PairLaw law, real time, real pressed, real half_step) { return (real3)(0); }
