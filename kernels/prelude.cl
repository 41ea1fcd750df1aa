// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Comes first in every program. Nothing may be fused behind our back: bits must not depend on what
// a compiler finds worth contracting.
#pragma OPENCL FP_CONTRACT OFF

// PoCL leaves a helper that is called twice as a call, which then blocks everything around it.
#define INLINE static inline __attribute__((always_inline))

#define NEVER 0x7fffffff
