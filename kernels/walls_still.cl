// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Every wall stands where it is drawn.
INLINE Stand stand_of(World w, const global Surface* surface, int step) {
  Stand s;
  s.offset = surface->offset;
  return s;
}
INLINE PlaneShape plane_now(Stand stand, const global Plane* plane) { return plane->shape; }
INLINE RectangleShape rectangle_now(Stand stand, const global Rectangle* rectangle) { return rectangle->shape; }
INLINE CylinderShape cylinder_now(Stand stand, const global Cylinder* cylinder) { return cylinder->shape; }
INLINE real3 spin_of_wall(const global Surface* surface) { return (real3)(0); }
INLINE real3 surface_velocity(Stand stand, const global Surface* surface, real3 from) { return (real3)(0); }
