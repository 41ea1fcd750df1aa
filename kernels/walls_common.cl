// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE ContactPoint wall_contact(Body self) {
  ContactPoint c;
  c.velocity = self.velocity;
  c.root_mass = square_root(1 / self.inverse_mass);
  c.share = 1;
  return c;
}

INLINE void meet_wall(World w, Load* load, Body self, ContactPoint c, int4 wall, int step) {
  meet(load, c, law_between(w, self.material, wall.x));
  const real deepest = w.constants->limits.x * in_metres(radius_of(self.position), w.box);
  if (c.overlap > deepest) blame(w, self.index, step, TOO_DEEP, -1 - wall.y, OVERLAPPED_AT);
}
