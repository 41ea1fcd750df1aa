// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Contacts as they stood at the last boundary. Spring and dashpot bend together where the limit takes hold of them.
INLINE bool bends(PairLaw law) { return (law.history & REMEMBERS) && !(law.history & LIMIT_ON_SPRING) && !law.hertz; }

// The rate of the overlap and the slip in the middle of the step that has led here.
INLINE real half_rate_of(World w, ContactPoint c, real3* slip) {
  const real3 other = c.other >= 0 ? w.middles[c.other].xyz : c.surface;
  const real3 velocity = w.middles[c.self].xyz - other;
  const real separating = velocity.x * c.normal.x + velocity.y * c.normal.y + velocity.z * c.normal.z;
  *slip = velocity - separating * c.normal - rolling_in(w.spin_middles, c.self, c.arm, c.other, c.other_arm, c.normal);
  return -separating;
}

INLINE real separating_rate(ContactPoint c) {
  return c.velocity.x * c.normal.x + c.velocity.y * c.normal.y + c.velocity.z * c.normal.z;
}

// Half of what rolling round each other has changed the normal of two spheres by, and the rate of the overlap in the
// middle of the step by the normal there, over that by the normal of now.
INLINE real3 half_way_round(World w, ContactPoint c) {
  return flat_against(w.middles[c.self].xyz - w.middles[c.other].xyz, c.normal) * (w.constants->time.y / c.apart);
}

INLINE real approach_by_turning(World w, ContactPoint c) {
  const real3 velocity = w.middles[c.self].xyz - w.middles[c.other].xyz, round = half_way_round(w, c);
  return velocity.x * round.x + velocity.y * round.y + velocity.z * round.z;
}

INLINE Before before_step(World w, ContactPoint c, PairLaw law) {
  const real separating = separating_rate(c);
  real3 slip;
  real middle = half_rate_of(w, c, &slip);
  const real3 foretold = c.velocity - separating * c.normal - c.rolling;
  if (bends(law)) {
    slip = stretching_slip(w, c, foretold);
    if (c.other >= 0) middle += approach_by_turning(w, c);
  }
  Before b;
  b.overlap = greater_of(c.overlap - w.constants->time.x * middle, 0);
  b.rate = middle + middle + separating;
  b.slip = slip + slip - foretold;
  b.gain = foretold - b.slip;
  b.force = full_force(b.overlap, -b.rate, law, c.root_mass, rise_of(b.overlap, c.radius, law));
  return b;
}
