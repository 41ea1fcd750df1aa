// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Moves a body with `velocity` for `drift`, back into the box through periodic faces.
INLINE void drift_body(World w, int i, real3 velocity, real drift, int step) {
  Position p = w.positions[i];
  if (w.constants->limits.y > 0 && longer_than_radius(p, velocity * drift)) blame(w, i, step, LEAPT, 0, ESCAPED_AT);
  if (!displace(&p, velocity, drift)) {
    blame(w, i, step, NOT_A_NUMBER, 0, ESCAPED_AT);
    return;
  }
  wrap(&p, w.box);
  const int face = face_left(p, w.box);
  if (face >= 0) blame(w, i, step, LEFT_DOMAIN, face, ESCAPED_AT);
  w.positions[i] = p;
}
