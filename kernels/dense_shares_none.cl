// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Stands for dense_shares.cl where cores share what they write at no cost: a work-item has a stretch of its own.
INLINE int claimed_stretch(global int* claims, global int* whose, int step, int shares) {
  return get_global_id(0);
}
INLINE void open_claims_of_next(global int* claims, int step, int shares) {}
