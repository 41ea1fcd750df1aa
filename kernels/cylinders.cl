// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A cylinder that particles are inside of is touched beyond its radius less theirs, one that they are outside of
// within the sum.
INLINE bool touches_cylinder(Separation s, Reach reach, CylinderShape shape, bool inside) {
  return inside ? !within(s, difference_of(shape.radius, reach)) : within(s, sum_of(shape.radius, reach));
}

INLINE real cylinder_overlap(Separation s, Reach reach, CylinderShape shape, bool inside, const global Box* box) {
  return inside ? -overlap_of(s, difference_of(shape.radius, reach), box)
                : overlap_of(s, sum_of(shape.radius, reach), box);
}

INLINE void meet_cylinders(World w, Load* load, Body self, int step) {
  const int cylinders = w.constants->walls.y, first = w.constants->counts.z + w.constants->counts.w;
  for (int k = 0; k < cylinders; ++k) {
    const global Cylinder* cylinder = &w.cylinders[k];
    const int slot = self.index * walls_of(w) + first + k;
    const bool inside = cylinder->surface.wall.w != 0;
    const Stand stand = stand_of(w, &cylinder->surface, step);
    const CylinderShape shape = cylinder_now(stand, cylinder);
    const Separation s = from_axis(self.position, shape);
    const Reach reach = reach_of(w, self.index, self.position);
    ContactPoint c = wall_contact(w, self, slot, step);
    if (!touches_cylinder(s, reach, shape, inside) && !was_touching(c.memory)) {
      miss_wall(w, load, c, slot);
      continue;
    }
    c.normal = inside ? -away_from_axis(s, shape) : away_from_axis(s, shape);
    c.overlap = cylinder_overlap(s, radius_of(self.position), shape, inside, w.box);
    c.reach_overlap = reaches_farther() ? cylinder_overlap(s, reach, shape, inside, w.box) : 0;
    const real3 from = from_plane(self.position, shape.across[0], w.box);
    meet_wall(w, load, self, c, from, stand, &cylinder->surface, slot, step);
  }
}
