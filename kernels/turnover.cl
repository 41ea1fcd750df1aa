// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A moment since the last boundary at which the Coulomb limit was lower than at either: where a contact begins, and
// where it goes from pressing to pulling or back. What the limit leaves of a spring then is what goes on from there.
typedef struct {
  real since;  // below 0 where there was none
  real3 slip;  // then
  real3 way;   // of the slip since then
  real limit;
  bool followed;   // friction too, kernels/onset_bend.cl:
  real3 now, rub;  // slip at the boundary; impulse until then, less what the plain scheme has of the last boundary
} Turnover;

// How a contact that has lasted through the whole step has turned in it, where the integrator follows that.
typedef struct {
  bool followed;
  bool rolls;    // two spheres, round each other
  real3 round;   // half of what that has changed the normal by
  real3 earlier; // slip at the step's start, as the dashpot would take it
} Turn;

INLINE Turnover no_turnover() {
  const Turnover t = {-1, (real3)(0), (real3)(0), 0, false, (real3)(0), (real3)(0)};
  return t;
}
