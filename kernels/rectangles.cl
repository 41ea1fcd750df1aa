// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void meet_rectangles(World w, Load* load, Body self, int step) {
  const int rectangles = w.constants->counts.w;
  for (int k = 0; k < rectangles; ++k) {
    const global Rectangle* rectangle = &w.rectangles[k];
    const int slot = self.index * walls_of(w) + w.constants->counts.z + k;
    const Stand stand = stand_of(w, &rectangle->surface, step);
    const RectangleShape shape = rectangle_now(stand, rectangle);
    const Separation s = rectangle_separation(self.position, shape, w.box);
    const Reach reach = reach_of(w, self.index, self.position);
    ContactPoint c = wall_contact(w, self, slot, step);
    if (!within(s, reach) && !was_touching(c.memory)) {
      miss_wall(w, load, c, slot);
      continue;
    }
    c.normal = direction_of(s);
    c.overlap = overlap_of(s, radius_of(self.position), w.box);
    c.reach_overlap = reaches_farther() ? overlap_of(s, reach, w.box) : 0;
    const real3 from = metres_of(separation(shape.centre, self.position, w.box), w.box);
    meet_wall(w, load, self, c, from, stand, &rectangle->surface, slot, step);
  }
}
