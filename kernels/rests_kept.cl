// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What rounding leaves out of a spring's stretch is kept in the last word of a memory and added with the next. Without it
// a float spring never feels a slip of less than half its last digit a step, and a pile at rest creeps for ever.
#define MEMORY_WORDS (2 + ROLLING_WORDS)
INLINE real3 rest_in(const global real4* memory) { return memory[MEMORY_WORDS - 1].xyz; }
INLINE void keep_rest(global real4* memory, real3 rest) { memory[MEMORY_WORDS - 1] = (real4)(rest, 0); }
