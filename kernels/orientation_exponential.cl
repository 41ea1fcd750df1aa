// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/rotation.md: q ← exp(½ ω Δt) q, written as a change of q so that nothing is lost where it turns little. The
// last term takes back what rounding has done to its length.
INLINE real4 change_of(real4 q, real3 turn) {
  const real angle = (real)0.5 * square_root(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
  const real slope = angle > 0 ? sin(angle) / angle : 1;
  const real half_sine = sin((real)0.5 * angle);
  const real excess = (real)0.5 * (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1);
  return half_turned(q, turn) * slope - q * (2 * half_sine * half_sine + excess);
}
