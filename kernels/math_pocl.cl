// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// PoCL's own sqrt, rint and fabs are heavy in loops; clang's builtins become one instruction each.
// oclgrind and others take math_plain.cl.
INLINE __attribute__((overloadable)) float builtin_root(float x) { return __builtin_sqrtf(x); }
INLINE __attribute__((overloadable)) double builtin_root(double x) { return __builtin_sqrt(x); }
INLINE __attribute__((overloadable)) float builtin_nearest(float x) { return __builtin_rintf(x); }
INLINE __attribute__((overloadable)) double builtin_nearest(double x) { return __builtin_rint(x); }
INLINE __attribute__((overloadable)) float builtin_magnitude(float x) { return __builtin_fabsf(x); }
INLINE __attribute__((overloadable)) double builtin_magnitude(double x) { return __builtin_fabs(x); }

INLINE real square_root(real x) { return builtin_root(x); }
INLINE real nearest(real x) { return builtin_nearest(x); }
INLINE real magnitude(real x) { return builtin_magnitude(x); }
INLINE void fetch_ahead(const global void* what) { __builtin_prefetch((const void*)(size_t)what); }
INLINE real greater_of(real a, real b) { return a > b ? a : b; }
INLINE real lesser_of(real a, real b) { return a < b ? a : b; }
