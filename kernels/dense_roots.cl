// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Roots, inverse ones and quotients of which the last bit may be wrong. AVX-512 estimates them to 2^-14, which one step of
// Newton's takes to the precision of floats. One particle a work-item takes the same estimates, so that it gets the same
// bits.
#if defined(__clang__) && defined(__AVX512F__) && PHASE_BITS == 32
#define ESTIMATED 1
#else
#define ESTIMATED 0
#endif

#if ESTIMATED && LANES == 16
typedef float bare_float16 __attribute__((__vector_size__(64)));
#define BARE(x) __builtin_astype(x, bare_float16)
INLINE reals inverse_root_estimates(reals x) {
  return __builtin_astype(__builtin_ia32_rsqrt14ps512_mask(BARE(x), BARE(x), (ushort)-1), reals);
}
INLINE reals inverse_estimates(reals x) {
  return __builtin_astype(__builtin_ia32_rcp14ps512_mask(BARE(x), BARE(x), (ushort)-1), reals);
}
#elif ESTIMATED
typedef float bare_float4 __attribute__((__vector_size__(16)));
#define BARE(x) __builtin_astype((float4)(x), bare_float4)
INLINE reals inverse_root_estimates(reals x) {
  return __builtin_ia32_rsqrt14ss_mask(BARE(x), BARE(x), BARE(x), (uchar)-1)[0];
}
INLINE reals inverse_estimates(reals x) {
  return __builtin_ia32_rcp14ss_mask(BARE(x), BARE(x), BARE(x), (uchar)-1)[0];
}
#endif

#if ESTIMATED
INLINE reals inverse_roots_of(reals x) {
  const reals y = inverse_root_estimates(x);
  return fma(y, fma(x * y * -0.5f, y, (reals)(0.5f)), y);
}
INLINE reals inverses_of(reals x) {
  const reals y = inverse_estimates(x);
  return fma(y, fma(-x, y, (reals)(1)), y);
}
INLINE reals quick_roots_of(reals x) { return x > 0 ? x * inverse_roots_of(x) : 0; }
// √(a/b), or 1 where b is nothing or next to it.
INLINE reals root_ratios_of(reals a, reals b) {
  const reals ratio = a * inverses_of(b);
  return b > 1e-36f ? ratio * inverse_roots_of(ratio) : 1;
}
#else
INLINE reals inverse_roots_of(reals x) { return 1 / roots_of(x); }
INLINE reals inverses_of(reals x) { return 1 / x; }
INLINE reals quick_roots_of(reals x) { return roots_of(x > 0 ? x : 0); }
INLINE reals root_ratios_of(reals a, reals b) { return b > 0 ? roots_of(a / b) : 1; }
#endif
