// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Functions of the OpenCL library, for every device but PoCL's.
INLINE real square_root(real x) { return sqrt(x); }
INLINE real nearest(real x) { return rint(x); }
INLINE real magnitude(real x) { return fabs(x); }
INLINE void fetch_ahead(const global void* what) {}
INLINE real greater_of(real a, real b) { return a > b ? a : b; }
INLINE real lesser_of(real a, real b) { return a < b ? a : b; }
