// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A spring's stretch is added as it is.
#define MEMORY_WORDS (1 + ROLLING_WORDS)
INLINE real3 rest_in(const global real4* memory) { return (real3)(0); }
INLINE void keep_rest(global real4* memory, real3 rest) {}
