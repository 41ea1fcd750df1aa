// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What is told of positions in double, kernels/position_double.cl, as floats. Whatever cancels does so in double, and
// is rounded when it has. docs/precision.md
INLINE float3 rounded3(double3 d) { return (float3)((float)d.x, (float)d.y, (float)d.z); }

INLINE real in_metres(Reach r, const global Box* box) { return (float)r; }

INLINE float distance_of(Separation s) {
  const float3 d = rounded3(s.across);
  return square_root(d.x * d.x + d.y * d.y + d.z * d.z);
}

// (σ² − r²)/(σ + r): no root in double.
INLINE real overlap_of(Separation s, Reach reach, const global Box* box) {
  const double square = s.across.x * s.across.x + s.across.y * s.across.y + s.across.z * s.across.z;
  return (float)(reach * reach - square) / ((float)reach + distance_of(s));
}

INLINE bool coincide(Separation s) { return !(distance_of(s) > 0); }

INLINE real3 direction_of(Separation s) {
  const real inverse = 1 / distance_of(s);
  return rounded3(s.across) * inverse;
}

INLINE real3 metres_of(Separation s, const global Box* box) { return rounded3(s.across); }

INLINE real plane_overlap(Position p, Reach reach, PlaneShape plane, const global Box* box) {
  return (float)(reach - height_over(p, plane));
}

INLINE real3 plane_normal(PlaneShape plane) { return rounded3(plane.normal.xyz); }

// From the point that a plane is held by, in metres.
INLINE real3 from_plane(Position p, PlaneShape plane, const global Box* box) {
  return rounded3(p.at.xyz - plane.point.xyz);
}

INLINE real3 away_from_axis(Separation s, CylinderShape cylinder) {
  const real3 d = direction_of(s);
  return d.x * rounded3(cylinder.across[0].normal.xyz) + d.y * rounded3(cylinder.across[1].normal.xyz);
}

INLINE bool longer_than_radius(Position p, real3 way) {
  const float radius = (float)p.at.w;
  return way.x * way.x + way.y * way.y + way.z * way.z > radius * radius;
}

// False when the new position is no number.
INLINE bool displace(Position* p, real3 velocity, real drift) {
  const double time = drift;
  p->at.xyz += (double3)(velocity.x * time, velocity.y * time, velocity.z * time);
  return !isnan(p->at.x + p->at.y + p->at.z);
}

// Within half a turn of zero, so that a float is as good far out as near the origin.
INLINE float phase_along(double x, double number) {
  const double turns = x * number * (1 / (2 * 0x1.921fb54442d18p+1));
  return (float)((turns - rint(turns)) * (2 * 0x1.921fb54442d18p+1));
}

INLINE real3 phase_of(Position p, const global Wave* wave) {
  const double3 x = p.at.xyz + wave->origin.xyz, number = wave->number.xyz;
  return (real3)(phase_along(x.x, number.x), phase_along(x.y, number.y), phase_along(x.z, number.z));
}
