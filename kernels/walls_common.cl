// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE ContactPoint wall_contact(World w, Body self, int slot, int step) {
  ContactPoint c;
  c.velocity = self.velocity;
  c.root_mass = square_root(1 / self.inverse_mass);
  c.radius = in_metres(radius_of(self.position), w.box);
  c.duration = step > 0 ? w.constants->time.x : 0;
  c.spring = spring_of_wall(w, self.index, slot);
  c.share = 1;
  return c;
}

INLINE void meet_wall(World w, Load* load, Body self, ContactPoint c, int4 wall, int step) {
  const PairLaw law = law_between(w, self.material, wall.x);
  c.arm = torque_arm(c.radius, c.overlap, law);
  c.rolling = rolling_on_wall(w, self.index, c.arm, c.normal);
  meet(load, c, law);
  if (c.overlap > w.constants->limits.x * c.radius) blame(w, self.index, step, TOO_DEEP, -1 - wall.y, OVERLAPPED_AT);
}
