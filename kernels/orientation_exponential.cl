// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// sin(a)/a − 1 from a²: by its series where the difference would lose digits.
INLINE real slope_excess(real square) {
  if (square > (real)0.25) {
    const real angle = square_root(square);
    return sin(angle) / angle - 1;
  }
  const real fifth = 1 - square / 110 * (1 - square / 156);
  return -square / 6 * (1 - square / 20 * (1 - square / 42 * (1 - square / 72 * fifth)));
}

// docs/laws/rotation.md: q ← exp(½ ω Δt) q, written as a change of q so that nothing is lost where it turns little. The
// last term takes back what rounding has done to its length.
INLINE real4 change_of(real4 q, real4 rest, real3 turn, real3 left) {
  const real square = (real)0.25 * (turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
  const real half_sine = sin((real)0.5 * square_root(square));
  const real excess = (real)0.5 * (q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1);
  const real4 straight = half_turned(q, turn);
  const real4 small = straight * slope_excess(square) + half_turned(q, left) + half_turned(rest, turn);
  return straight + (small - q * (2 * half_sine * half_sine + excess));
}
