// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// ½ (turn, 0) q; the scalar part stands last.
INLINE real4 half_turned(real4 q, real3 turn) {
  const real3 v = q.w * turn + across(turn, q.xyz);
  return (real)0.5 * (real4)(v, -(turn.x * q.x + turn.y * q.y + turn.z * q.z));
}
