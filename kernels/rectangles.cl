// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void meet_rectangles(World w, Load* load, Body self, int step) {
  const int rectangles = w.constants->counts.w;
  for (int k = 0; k < rectangles; ++k) {
    const global Rectangle* rectangle = &w.rectangles[k];
    const Separation s = rectangle_separation(self.position, &rectangle->shape, w.box);
    const Reach reach = reach_of(w, self.index, self.position);
    ContactPoint c = wall_contact(w, self, w.constants->counts.z + k, step);
    if (!within(s, reach)) {
      release_spring(c.spring, c.share, c.duration, &load->account);
      continue;
    }
    c.normal = direction_of(s);
    c.overlap = overlap_of(s, radius_of(self.position), w.box);
    c.reach_overlap = reaches_farther() ? overlap_of(s, reach, w.box) : 0;
    meet_wall(w, load, self, c, rectangle->wall, step);
  }
}
