// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/walls.md. The host works out where every moving wall stands and how fast it goes at every step, in double.
INLINE bool is_tracked(const global Surface* surface) { return surface->wall.z >= 0; }

INLINE Stand stand_of(World w, const global Surface* surface, int step) {
  Stand s;
  s.velocity = surface->velocity;
  s.offset = surface->offset;
  if (is_tracked(surface)) s = w.stands[(step - w.table_origin) * w.constants->walls.z + surface->wall.z];
  s.tracked = is_tracked(surface);
  return s;
}

INLINE PlaneShape plane_now(Stand stand, const global Plane* plane) {
  return stand.tracked ? plane_through(plane->shape, stand.shape.centre) : plane->shape;
}

INLINE RectangleShape rectangle_now(Stand stand, const global Rectangle* rectangle) {
  return stand.tracked ? stand.shape : rectangle->shape;
}

INLINE CylinderShape cylinder_now(Stand stand, const global Cylinder* cylinder) {
  CylinderShape shape = cylinder->shape;
  if (stand.tracked) {
    shape.across[0] = plane_through(shape.across[0], stand.shape.centre);
    shape.across[1] = plane_through(shape.across[1], stand.shape.centre);
  }
  return shape;
}

INLINE real3 spin_of_wall(const global Surface* surface) { return surface->spin.xyz; }

// At a point of the surface that lies `from` where the wall's shape is held.
INLINE real3 surface_velocity(Stand stand, const global Surface* surface, real3 from) {
  const real3 spin = surface->spin.xyz;
  const real3 turning = (real3)(spin.y * from.z - spin.z * from.y, spin.z * from.x - spin.x * from.z,
                                spin.x * from.y - spin.y * from.x);
  return stand.velocity.xyz + turning;
}
