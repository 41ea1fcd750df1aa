// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real3 gravity_at(World w, Position p, int step) {
  const Separation inwards = separation(p, w.constants->gravity_centre, w.box);
  if (coincide(inwards)) return (real3)(0);
  return direction_of(inwards) * w.constants->gravity.w;
}
