// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/rotation.md: q ← q + ½ Δt ω q, whose length grows (E14).
INLINE real4 change_of(real4 q, real4 rest, real3 turn, real3 left) {
  return half_turned(q, turn) + (half_turned(q, left) + half_turned(rest, turn));
}
