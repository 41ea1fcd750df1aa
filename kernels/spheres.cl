// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE real effective_root_mass(real inverse_a, real inverse_b) { return square_root(1 / (inverse_a + inverse_b)); }

// What sphere j does to sphere i; the slot is their spring's.
INLINE void meet_sphere(World w, Load* load, Body self, int j, int slot, int step) {
  const Body other = load_body(w, j);
  const Separation s = separation(other.position, self.position, w.box);
  const Reach radii = sum_of(radius_of(self.position), radius_of(other.position));
  const Reach reach = sum_of(reach_of(w, self.index, self.position), reach_of(w, j, other.position));
  const PairLaw law = law_between(w, self.material, other.material);
  ContactPoint c;
  c.memory = memory_of_pair(w, slot);
  c.duration = step > 0 ? w.constants->time.x : 0;
  c.starting = step == 0;
  c.foresight = step > 0 ? w.constants->time.x : 0;
  c.self = self.index;
  c.other = j;
  c.share = other.inverse_mass > 0 ? (real)0.5 : (real)1;
  if (!within(s, reach) && !was_touching(c.memory)) {
    forget(c.memory);
    return;
  }
  const real radius = in_metres(radius_of(self.position), w.box);
  const real other_radius = in_metres(radius_of(other.position), w.box);
  c.normal = direction_of(s);
  c.velocity = self.velocity - other.velocity;
  c.surface = c.wall_spin = (real3)(0);
  c.overlap = overlap_of(s, radii, w.box);
  c.reach_overlap = reaches_farther() ? overlap_of(s, reach, w.box) : 0;
  c.inverse_mass = self.inverse_mass + other.inverse_mass;
  c.apart = radius + other_radius - c.overlap;
  c.root_mass = effective_root_mass(self.inverse_mass, other.inverse_mass);
  c.radius = radius * other_radius / (radius + other_radius);
  c.arm = torque_arm(radius, c.overlap, law);
  c.other_arm = torque_arm(other_radius, c.overlap, law);
  c.rolling = rolling_of_pair(w, self.index, c.arm, j, c.other_arm, c.normal);
  c.spin = spin_of(w, self.index) - spin_of(w, j);
  c.winding = winding_spin(w, self.index) - winding_spin(w, j);
  meet(w, load, c, law);
  if (c.overlap > w.constants->limits.x * lesser_of(radius, other_radius))
    blame(w, self.index, step, TOO_DEEP, j, OVERLAPPED_AT);
}
