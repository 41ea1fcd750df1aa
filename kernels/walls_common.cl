// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE ContactPoint wall_contact(World w, Body self, int slot, int step) {
  ContactPoint c;
  c.root_mass = square_root(1 / self.inverse_mass);
  c.radius = in_metres(radius_of(self.position), w.box);
  c.duration = stretch_time(w, step);
  c.starting = step == 0;
  c.foresight = step > 0 ? w.constants->time.x : 0;
  c.self = self.index;
  c.other = -1;
  c.other_arm = c.apart = 0;
  c.inverse_mass = self.inverse_mass;
  c.memory = memory_of_wall(w, slot);
  c.share = 1;
  return c;
}

// A wall in whose reach the body is; `from` goes from where the wall's shape is held to the body's centre.
INLINE void meet_wall(World w, Load* load, Body self, ContactPoint c, real3 from, Stand stand,
                      const global Surface* surface, int slot, int step) {
  const PairLaw law = law_between(w, self.material, surface->wall.x);
  const real3 touched = from - (c.radius - c.overlap) * c.normal;
  c.surface = surface_velocity(stand, surface, touched);
  c.wall_spin = spin_of_wall(surface);
  c.velocity = self.velocity - c.surface;
  c.arm = torque_arm(c.radius, c.overlap, law);
  c.rolling = rolling_on_wall(w, self.index, c.arm, c.normal);
  c.spin = winding_on_wall(spin_of(w, self.index) - c.wall_spin, c.radius, c.overlap, law);
  c.winding = winding_on_wall(winding_spin(w, self.index) - c.wall_spin, c.radius, c.overlap, law);
  open_wall(&load->account);
  meet(w, load, c, law);
  close_wall(w, slot, load->account, touched + stand.offset.xyz);
  book_wall_events(w, slot, load->account, touched + stand.offset.xyz);
  if (c.overlap > w.constants->limits.x * c.radius)
    blame(w, self.index, step, TOO_DEEP, -1 - surface->wall.y, OVERLAPPED_AT);
}

INLINE void miss_wall(World w, Load* load, ContactPoint c, int slot) {
  forget(c.memory);
  open_wall(&load->account);
  close_wall(w, slot, load->account, (real3)(0));
}
