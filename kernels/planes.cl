// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void meet_planes(World w, Load* load, Body self, int step) {
  const int planes = w.constants->counts.z;
  for (int k = 0; k < planes; ++k) {
    const global Plane* plane = &w.planes[k];
    ContactPoint c = wall_contact(w, self, k, step);
    c.normal = plane_normal(&plane->shape);
    c.overlap = plane_overlap(self.position, radius_of(self.position), &plane->shape, w.box);
    c.reach_overlap =
        reaches_farther() ? plane_overlap(self.position, reach_of(w, self.index, self.position), &plane->shape, w.box)
                          : 0;
    meet_wall(w, load, self, c, plane->wall, step);
  }
}
