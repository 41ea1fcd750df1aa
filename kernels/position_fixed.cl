// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Positions in single precision: whole quanta from the domain's lower corner, plus what is left over as
// a float in [-1/2, 1/2] quanta. A quantum is 2^-30 of the domain's longest side. Overlaps come from
// integer differences, so nothing cancels. docs/precision.md
typedef struct {
  int4 whole;   // w: body radius
  float4 part;  // w: body radius
} Position;

typedef struct {
  int whole;
  float part;
} Reach;  // a length along a line of centres, quanta

typedef struct {
  int4 whole;        // extent
  float4 part;
  int4 period;       // whole where the axis is periodic, else 0
  float4 period_part;
  int4 half_period;  // beyond reach where the axis is not periodic
  ulong4 zone_scale; // zones per quantum, times 2^50
  int4 zones;
  float4 quantum;    // x: m
  Reach skin;
  Reach half_skin;
} Box;

typedef struct {
  int3 whole;
  float3 part;
} Separation;

typedef struct {
  int4 whole;           // a point of the plane
  float4 part;
  long4 normal_whole;   // normal = normal_whole 2^-30 + normal_part
  float4 normal_part;
  float4 normal;
} PlaneShape;

typedef struct {
  Position centre;
  int4 half_whole;
  float4 half_part;
} RectangleShape;

typedef struct {
  PlaneShape across[2];  // planes through the axis, perpendicular to each other
  Reach radius;
} CylinderShape;

typedef struct {
  ulong4 offset;            // turns, times 2^64
  ulong4 turns;             // per quantum, times 2^64
  float4 radians;           // per quantum
} Wave;

INLINE Reach radius_of(Position p) {
  Reach r = {p.whole.w, p.part.w};
  return r;
}

INLINE Reach sum_of(Reach a, Reach b) {
  Reach r = {a.whole + b.whole, a.part + b.part};
  return r;
}

INLINE Reach difference_of(Reach a, Reach b) {
  Reach r = {a.whole - b.whole, a.part - b.part};
  return r;
}

INLINE real in_metres(Reach r, const global Box* box) { return ((float)r.whole + r.part) * box->quantum.x; }

INLINE void nearest_image(int* whole, float* part, int period, float period_part, int half_period) {
  const int images = (*whole > half_period) - (*whole < -half_period);
  *whole -= images * period;
  *part -= (float)images * period_part;
}

// From one centre to another, by the nearest periodic image.
INLINE Separation separation(Position from, Position to, const global Box* box) {
  int4 whole = to.whole - from.whole;
  float4 part = to.part - from.part;
  int wx = whole.x, wy = whole.y, wz = whole.z;
  float px = part.x, py = part.y, pz = part.z;
  if (PERIODIC_X) nearest_image(&wx, &px, box->period.x, box->period_part.x, box->half_period.x);
  if (PERIODIC_Y) nearest_image(&wy, &py, box->period.y, box->period_part.y, box->half_period.y);
  if (PERIODIC_Z) nearest_image(&wz, &pz, box->period.z, box->period_part.z, box->half_period.z);
  Separation s;
  s.whole = (int3)(wx, wy, wz);
  s.part = (float3)(px, py, pz);
  return s;
}

INLINE float3 quanta_of(Separation s) { return convert_float3(s.whole) + s.part; }

INLINE float distance_in_quanta(Separation s) {
  const float3 d = quanta_of(s);
  return square_root(d.x * d.x + d.y * d.y + d.z * d.z);
}

// reach² − distance², in quanta². The large parts cancel as integers: exact.
INLINE float square_difference(Separation s, Reach reach) {
  const long x = s.whole.x, y = s.whole.y, z = s.whole.z, r = reach.whole;
  const long coarse = r * r - (x * x + y * y + z * z);
  const float3 w = convert_float3(s.whole);
  const float3 p = s.part;
  const float along = w.x * p.x + w.y * p.y + w.z * p.z;
  const float square = p.x * p.x + p.y * p.y + p.z * p.z;
  const float fine = (2 * ((float)reach.whole * reach.part - along)) + (reach.part * reach.part - square);
  return (float)coarse + fine;
}

// Parts add up to less than 8 quanta along any line, so most pairs are told apart by integers alone.
INLINE bool within(Separation s, Reach reach) {
  const long x = s.whole.x, y = s.whole.y, z = s.whole.z, r = (long)reach.whole + 8;
  if (r * r < x * x + y * y + z * z) return false;
  return square_difference(s, reach) > 0;
}

INLINE real overlap_of(Separation s, Reach reach, const global Box* box) {
  const float sum = (float)reach.whole + reach.part + distance_in_quanta(s);
  return box->quantum.x * (square_difference(s, reach) / sum);
}

INLINE bool coincide(Separation s) { return !(distance_in_quanta(s) > 0); }

INLINE real3 direction_of(Separation s) {
  const real inverse = 1 / distance_in_quanta(s);
  return quanta_of(s) * inverse;
}

INLINE real3 metres_of(Separation s, const global Box* box) { return quanta_of(s) * box->quantum.x; }

// Height of a centre over a plane: `coarse` in 2^-30 quanta is exact, and `fine` in quanta is small.
INLINE void height_over(Position p, PlaneShape plane, long* coarse, float* fine) {
  const long x = p.whole.x - plane.whole.x, y = p.whole.y - plane.whole.y, z = p.whole.z - plane.whole.z;
  *coarse = x * plane.normal_whole.x + y * plane.normal_whole.y + z * plane.normal_whole.z;
  const float tilt =
      (float)x * plane.normal_part.x + (float)y * plane.normal_part.y + (float)z * plane.normal_part.z;
  const float3 d = p.part.xyz - plane.part.xyz;
  *fine = tilt + (d.x * plane.normal.x + d.y * plane.normal.y + d.z * plane.normal.z);
}

INLINE real plane_overlap(Position p, Reach reach, PlaneShape plane, const global Box* box) {
  long height;
  float fine;
  height_over(p, plane, &height, &fine);
  const long coarse = ((long)reach.whole << 30) - height;
  return box->quantum.x * ((float)coarse * 0x1p-30f + (reach.part - fine));
}

INLINE real3 plane_normal(PlaneShape plane) { return plane.normal.xyz; }

INLINE PlaneShape plane_through(PlaneShape plane, Position point) {
  plane.whole = point.whole;
  plane.part = point.part;
  return plane;
}

// From the point that a plane is held by, in metres.
INLINE real3 from_plane(Position p, PlaneShape plane, const global Box* box) {
  return (convert_float3(p.whole.xyz - plane.whole.xyz) + (p.part.xyz - plane.part.xyz)) * box->quantum.x;
}

// Whole quanta, and what is left over with what is fine.
INLINE void split_height(Position p, PlaneShape plane, int* whole, float* part) {
  long coarse;
  float fine;
  height_over(p, plane, &coarse, &fine);
  const long quanta = (coarse + (1L << 29)) >> 30;
  *whole = (int)quanta;
  *part = (float)(coarse - (quanta << 30)) * 0x1p-30f + fine;
}

// From the axis of a cylinder to the centre, along its two planes' normals.
INLINE Separation from_axis(Position p, CylinderShape cylinder) {
  int wx, wy;
  float px, py;
  split_height(p, cylinder.across[0], &wx, &px);
  split_height(p, cylinder.across[1], &wy, &py);
  Separation s;
  s.whole = (int3)(wx, wy, 0);
  s.part = (float3)(px, py, 0);
  return s;
}

INLINE real3 away_from_axis(Separation s, CylinderShape cylinder) {
  const real3 d = direction_of(s);
  return d.x * cylinder.across[0].normal.xyz + d.y * cylinder.across[1].normal.xyz;
}

INLINE void beyond(int* whole, float* part, int half_whole, float half_part) {
  const float above = (float)(*whole - half_whole) + (*part - half_part);
  const float below = (float)(*whole + half_whole) + (*part + half_part);
  const int side = (above > 0) - (below < 0);
  *whole = side == 0 ? 0 : *whole - side * half_whole;
  *part = side == 0 ? 0 : *part - (float)side * half_part;
}

// From the closest point of the rectangle to the centre.
INLINE Separation rectangle_separation(Position p, RectangleShape shape, const global Box* box) {
  const Separation s = separation(shape.centre, p, box);
  int wx = s.whole.x, wy = s.whole.y, wz = s.whole.z;
  float px = s.part.x, py = s.part.y, pz = s.part.z;
  beyond(&wx, &px, shape.half_whole.x, shape.half_part.x);
  beyond(&wy, &py, shape.half_whole.y, shape.half_part.y);
  beyond(&wz, &pz, shape.half_whole.z, shape.half_part.z);
  Separation closest;
  closest.whole = (int3)(wx, wy, wz);
  closest.part = (float3)(px, py, pz);
  return closest;
}

// Carries whole quanta out of a displacement; what is left is never lost.
INLINE void carry(int* whole, float* part, float displacement) {
  const float leap = nearest(displacement);
  const float left = *part + (displacement - leap);
  const float step = nearest(left);
  *whole += (int)leap + (int)step;
  *part = left - step;
}

INLINE bool longer_than_radius(Position p, real3 way) {
  const float radius = (float)p.whole.w + p.part.w;
  return way.x * way.x + way.y * way.y + way.z * way.z > radius * radius;
}

// False when the new position is no number, or farther away than a position can say.
INLINE bool displace(Position* p, real3 velocity, real drift) {
  const float3 d = velocity * drift;
  const float longest = 0x1p30f;
  if (!(magnitude(d.x) < longest && magnitude(d.y) < longest && magnitude(d.z) < longest)) return false;
  int wx = p->whole.x, wy = p->whole.y, wz = p->whole.z;
  float px = p->part.x, py = p->part.y, pz = p->part.z;
  carry(&wx, &px, d.x);
  carry(&wy, &py, d.y);
  carry(&wz, &pz, d.z);
  p->whole = (int4)(wx, wy, wz, p->whole.w);
  p->part = (float4)(px, py, pz, p->part.w);
  return true;
}

INLINE void wrap_axis(int* whole, float* part, int extent, int period, float period_part) {
  // To the fraction of a quantum: half a quantum below the upper face is no place below the lower one.
  const float beyond_upper = (float)(*whole - extent) + (*part - period_part);
  const int turns = (beyond_upper >= 0) - (*whole < 0);
  *whole -= turns * period;
  carry(whole, part, -(float)turns * period_part);
}

INLINE void wrap(Position* p, const global Box* box) {
  int wx = p->whole.x, wy = p->whole.y, wz = p->whole.z;
  float px = p->part.x, py = p->part.y, pz = p->part.z;
  if (PERIODIC_X) wrap_axis(&wx, &px, box->whole.x, box->period.x, box->period_part.x);
  if (PERIODIC_Y) wrap_axis(&wy, &py, box->whole.y, box->period.y, box->period_part.y);
  if (PERIODIC_Z) wrap_axis(&wz, &pz, box->whole.z, box->period.z, box->period_part.z);
  p->whole = (int4)(wx, wy, wz, p->whole.w);
  p->part = (float4)(px, py, pz, p->part.w);
}

// Which face the centre lies beyond: 0 … 5 for −x, +x, −y, …; −1 inside.
INLINE int face_left(Position p, const global Box* box) {
  if (p.whole.x < 0) return 0;
  if (p.whole.x > box->whole.x) return 1;
  if (p.whole.y < 0) return 2;
  if (p.whole.y > box->whole.y) return 3;
  if (p.whole.z < 0) return 4;
  if (p.whole.z > box->whole.z) return 5;
  return -1;
}

// Clamped, so that a lost particle never indexes out of bounds.
INLINE int3 zone_of(Position p, const global Box* box) {
  const int3 inside = max(p.whole.xyz, (int3)(0));
  const ulong3 zone = (convert_ulong3(inside) * box->zone_scale.xyz) >> (ulong3)(50);
  return min(convert_int3(zone), box->zones.xyz - 1);
}

// Turns are counted modulo one in 64-bit integers, so a phase is as exact far out as near the origin.
INLINE float phase_along(int whole, float part, ulong offset, ulong turns, float radians) {
  const ulong turn = offset + (ulong)(long)whole * turns;
  return (float)(int)(turn >> 32) * (0x1p-32f * 2 * PI) + part * radians;
}

INLINE real3 phase_of(Position p, const global Wave* wave) {
  return (real3)(phase_along(p.whole.x, p.part.x, wave->offset.x, wave->turns.x, wave->radians.x),
                 phase_along(p.whole.y, p.part.y, wave->offset.y, wave->turns.y, wave->radians.y),
                 phase_along(p.whole.z, p.part.z, wave->offset.z, wave->turns.z, wave->radians.z));
}
