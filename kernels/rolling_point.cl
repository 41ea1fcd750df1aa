// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What rolling resistance may know of a contact.
typedef struct {
  real3 spin;         // of the second body relative to the first
  real3 winding;      // likewise, what winds a spring
  real3 wall_spin;
  real3 normal;
  real radius;        // effective
  real elastic;       // normal force of the overlap alone
  real pressing;      // normal force
  real stiffness;     // k_t
  real duration, share;
  real since;         // of a moment with a limit of 0, kernels/turnover.cl
  global real4* memory;
} Rolling;
