// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What is told of positions in double, kernels/position_double.cl, in double too.
INLINE real in_metres(Reach r, const global Box* box) { return r; }

INLINE real distance_of(Separation s) {
  return square_root(s.across.x * s.across.x + s.across.y * s.across.y + s.across.z * s.across.z);
}

INLINE real overlap_of(Separation s, Reach reach, const global Box* box) { return reach - distance_of(s); }

INLINE bool coincide(Separation s) { return !(distance_of(s) > 0); }

INLINE real3 direction_of(Separation s) {
  const real inverse = 1 / distance_of(s);
  return s.across * inverse;
}

INLINE real3 metres_of(Separation s, const global Box* box) { return s.across; }

INLINE real plane_overlap(Position p, Reach reach, PlaneShape plane, const global Box* box) {
  return reach - height_over(p, plane);
}

INLINE real3 plane_normal(PlaneShape plane) { return plane.normal.xyz; }

// From the point that a plane is held by, in metres.
INLINE real3 from_plane(Position p, PlaneShape plane, const global Box* box) { return p.at.xyz - plane.point.xyz; }

INLINE real3 away_from_axis(Separation s, CylinderShape cylinder) {
  const real3 d = direction_of(s);
  return d.x * cylinder.across[0].normal.xyz + d.y * cylinder.across[1].normal.xyz;
}

INLINE bool longer_than_radius(Position p, real3 way) {
  return way.x * way.x + way.y * way.y + way.z * way.z > p.at.w * p.at.w;
}

// False when the new position is no number.
INLINE bool displace(Position* p, real3 velocity, real drift) {
  p->at.xyz += velocity * drift;
  return !isnan(p->at.x + p->at.y + p->at.z);
}

INLINE real3 phase_of(Position p, const global Wave* wave) {
  return (p.at.xyz + wave->origin.xyz) * wave->number.xyz;
}
