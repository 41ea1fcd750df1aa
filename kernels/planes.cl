// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void meet_planes(World w, Load* load, Body self, int step) {
  const int planes = w.constants->counts.z;
  for (int k = 0; k < planes; ++k) {
    const global Plane* plane = &w.planes[k];
    const int slot = self.index * walls_of(w) + k;
    const Stand stand = stand_of(w, &plane->surface, step);
    const PlaneShape shape = plane_now(stand, plane);
    ContactPoint c = wall_contact(w, self, slot, step);
    c.normal = plane_normal(shape);
    c.overlap = plane_overlap(self.position, radius_of(self.position), shape, w.box);
    c.reach_overlap =
        reaches_farther() ? plane_overlap(self.position, reach_of(w, self.index, self.position), shape, w.box) : 0;
    meet_wall(w, load, self, c, from_plane(self.position, shape, w.box), stand, &plane->surface, slot, step);
  }
}
