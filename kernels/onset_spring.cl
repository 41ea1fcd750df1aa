// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A tangential spring as events see it, kernels/history.cl: what is remembered, in the tangent plane of now, and the
// force, or the impulse, against the slip.
INLINE real3 remembered_spring(const global real4* memory, real3 normal, PairLaw law) {
  return turned(memory->xyz, normal, law);
}

// What the Coulomb limit leaves of a new spring.
INLINE real3 left_of(real3 damped, real stiffness, real limit, PairLaw law) {
  return law.history & REMEMBERS ? gripped((real3)(0), damped, stiffness, limit, law).spring : (real3)(0);
}

INLINE real3 gripping(real3 spring, real3 damped, real stiffness, real limit, PairLaw law) {
  if (!(law.history & REMEMBERS)) return (real3)(0);
  return gripped(spring, damped, stiffness, limit, law).force;
}
