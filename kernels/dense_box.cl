// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What the dense path knows of its box, its bodies when they are all alike, and its step. opencl/dense_image.hpp
typedef struct {
  double4 quantum;       // m a unit of phase along each axis; w: a unit of radius
  double4 lower;         // m, where cells begin
  double4 cell;          // m
  double4 domain_lower;  // without bound along periodic axes
  double4 domain_upper;
  double4 coarse;        // coarse units a cell
  double4 alike;         // x: σ; y: radius; z: reach of walls and faces at a rebuild, beyond a radius; w: margin of faces
  real4 metre;           // quantum, rounded
  real4 drift;           // units of phase a step at 1 m/s
  real4 gravity;
  real4 time;            // x: step; y: half of it; z: (highest speed)²; w: x², or 0 where a leap is none
  real4 limits;          // x: largest overlap, as a fraction of the smaller radius; y: (skin/2)²; z: a little over 1
  real4 body;            // x: radius; y: 1/mass; z: 1/inertia; w: root of the effective mass of two
  real4 body_units;      // of sums in canonical order. x: of force, N; y: of torque, N m
  float4 coarse_metre;   // m a coarse unit; w: how far the list looks beyond two radii
  float4 near;           // x: how far a pair counts as near beyond two radii; y: largest reach of the list; z: of near
  int4 cells;
  int4 zones;
  int4 counts;           // particles, planes, materials, the material of all particles
  int4 periodic;         // w: rows of zones that stand abreast, dense_order.cl
} DenseBox;

typedef struct {
  double4 normal;  // w: normal·point
  int4 wall;       // x: material, y: index among the scene's walls
} DensePlane;

#define FACE_BIT 30  // of a group's mask of walls: some face of the domain is near

// Components of vectors of a whole vector of particles.
typedef struct {
  reals x, y, z;
} Vectors;

INLINE Vectors vectors(reals x, reals y, reals z) {
  const Vectors v = {x, y, z};
  return v;
}
INLINE Vectors xyz_of(Quarter q) { return vectors(q.x, q.y, q.z); }
INLINE reals inner(Vectors a, Vectors b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
INLINE Vectors outer(Vectors a, Vectors b) {
  return vectors(fma(a.y, b.z, -(a.z * b.y)), fma(a.z, b.x, -(a.x * b.z)), fma(a.x, b.y, -(a.y * b.x)));
}
INLINE Vectors scaled(Vectors a, reals s) { return vectors(a.x * s, a.y * s, a.z * s); }
INLINE Vectors less(Vectors a, Vectors b) { return vectors(a.x - b.x, a.y - b.y, a.z - b.z); }
INLINE Vectors plus_scaled(Vectors a, Vectors b, reals s) {
  return vectors(fma(b.x, s, a.x), fma(b.y, s, a.y), fma(b.z, s, a.z));
}
INLINE Vectors chosen(flags f, Vectors a, Vectors b) {
  return vectors(f ? a.x : b.x, f ? a.y : b.y, f ? a.z : b.z);
}
