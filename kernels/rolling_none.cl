// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing resists rolling.
INLINE void resist_rolling(Turning* turning, Rolling r, PairLaw law, Account* account) {}
