// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions as doubles, in metres from an origin that the host chooses near the scene. With lengths_double.cl or
// lengths_mixed.cl the same functions as position_fixed.cl; nothing outside these files knows how a position is held.
typedef struct {
  double4 at;  // w: body radius
} Position;

typedef double Reach;  // a length along a line of centres, m

typedef struct {
  double4 lower;
  double4 upper;
  double4 period;       // 0 along an axis that is not periodic
  double4 half_period;  // beyond reach there
  double4 zone_scale;   // zones per metre
  int4 zones;
  Reach skin;
  Reach half_skin;
} Box;

typedef struct {
  double3 across;
} Separation;

typedef struct {
  double4 point;
  double4 normal;
} PlaneShape;

typedef struct {
  Position centre;
  double4 half_extent;
} RectangleShape;

typedef struct {
  PlaneShape across[2];  // planes through the axis, perpendicular to each other
  Reach radius;
} CylinderShape;

typedef struct {
  double4 origin;
  double4 number;  // 1/m
} Wave;

INLINE Reach radius_of(Position p) { return p.at.w; }
INLINE Reach sum_of(Reach a, Reach b) { return a + b; }
INLINE Reach difference_of(Reach a, Reach b) { return a - b; }

INLINE double nearest_image(double d, double period, double half_period) {
  return d > half_period ? d - period : (d < -half_period ? d + period : d);
}

// From one centre to another, by the nearest periodic image.
INLINE Separation separation(Position from, Position to, const global Box* box) {
  double3 d = to.at.xyz - from.at.xyz;
  if (PERIODIC_X) d.x = nearest_image(d.x, box->period.x, box->half_period.x);
  if (PERIODIC_Y) d.y = nearest_image(d.y, box->period.y, box->half_period.y);
  if (PERIODIC_Z) d.z = nearest_image(d.z, box->period.z, box->half_period.z);
  Separation s;
  s.across = d;
  return s;
}

INLINE bool within(Separation s, Reach reach) {
  return s.across.x * s.across.x + s.across.y * s.across.y + s.across.z * s.across.z < reach * reach;
}

INLINE double height_over(Position p, PlaneShape plane) {
  const double3 d = p.at.xyz - plane.point.xyz;
  return d.x * plane.normal.x + d.y * plane.normal.y + d.z * plane.normal.z;
}

INLINE PlaneShape plane_through(PlaneShape plane, Position point) {
  plane.point = point.at;
  return plane;
}

// From the axis of a cylinder to the centre, along its two planes' normals.
INLINE Separation from_axis(Position p, CylinderShape cylinder) {
  Separation s;
  s.across = (double3)(height_over(p, cylinder.across[0]), height_over(p, cylinder.across[1]), 0);
  return s;
}

INLINE double beyond(double d, double half_extent) {
  return d > half_extent ? d - half_extent : (d < -half_extent ? d + half_extent : 0);
}

// From the closest point of the rectangle to the centre.
INLINE Separation rectangle_separation(Position p, RectangleShape shape, const global Box* box) {
  Separation s = separation(shape.centre, p, box);
  s.across.x = beyond(s.across.x, shape.half_extent.x);
  s.across.y = beyond(s.across.y, shape.half_extent.y);
  s.across.z = beyond(s.across.z, shape.half_extent.z);
  return s;
}

INLINE double wrapped(double x, double lower, double upper, double period) {
  return x < lower ? x + period : (x >= upper ? x - period : x);
}

INLINE void wrap(Position* p, const global Box* box) {
  if (PERIODIC_X) p->at.x = wrapped(p->at.x, box->lower.x, box->upper.x, box->period.x);
  if (PERIODIC_Y) p->at.y = wrapped(p->at.y, box->lower.y, box->upper.y, box->period.y);
  if (PERIODIC_Z) p->at.z = wrapped(p->at.z, box->lower.z, box->upper.z, box->period.z);
}

// Which face the centre lies beyond: 0 … 5 for −x, +x, −y, …; −1 inside.
INLINE int face_left(Position p, const global Box* box) {
  if (p.at.x < box->lower.x) return 0;
  if (p.at.x > box->upper.x) return 1;
  if (p.at.y < box->lower.y) return 2;
  if (p.at.y > box->upper.y) return 3;
  if (p.at.z < box->lower.z) return 4;
  if (p.at.z > box->upper.z) return 5;
  return -1;
}

// Clamped, so that a lost particle never indexes out of bounds.
INLINE int3 zone_of(Position p, const global Box* box) {
  const double3 zone = (p.at.xyz - box->lower.xyz) * box->zone_scale.xyz;
  const int3 last = box->zones.xyz - 1;
  return clamp(convert_int3_sat(zone), (int3)(0), last);
}
