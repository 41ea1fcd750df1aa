// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What a list is made of and for, however many are looked for at once: dense_list.cl, dense_list_each.cl.
typedef struct {
  global int4* heads;
  global uint* list;
  global real* springs;
  global int* marks;
} Latter;

typedef struct {
  const KNOWN DenseBox* box;
  const global DensePlane* planes;
  const global real4* records;  // as they stood before
  const global int* cells;
  const global int* members;
} Site;

// Bits of the planes that a particle may touch while the list lasts, and one for the faces of the domain.
INLINE int walls_near(const KNOWN DenseBox* box, const global DensePlane* planes, phase4 p, int3 cell) {
  int near = 0;
  const double4 size = box->cell, low = box->domain_lower, high = box->domain_upper;
  const double scale = PHASE_BITS == 32 ? 0x1p-32 : 0x1p-64, margin = box->alike.w;
  const double x = box->lower.x + ((double)cell.x + (double)(bare_phase)p.x * scale) * size.x;
  const double y = box->lower.y + ((double)cell.y + (double)(bare_phase)p.y * scale) * size.y;
  const double z = box->lower.z + ((double)cell.z + (double)(bare_phase)p.z * scale) * size.z;
  const double reach = box->alike.z + (VARIED ? (double)p.w * box->quantum.w : box->alike.y);
  for (int k = 0; k < box->counts.y; ++k) {
    const double4 n = planes[k].normal;
    if (x * n.x + y * n.y + z * n.z - n.w < reach) near |= 1 << k;
  }
  if (x - low.x < margin || high.x - x < margin || y - low.y < margin || high.y - y < margin || z - low.z < margin ||
      high.z - z < margin)
    near |= 1 << FACE_BIT;
  return near;
}

// Particles of a window are put in order of these: by near partners first, then by all.
#define BUCKETS 512
INLINE int bucket_of(int near, int far) { return min(near, 15) * 32 + min(near + far, 31); }

// The k-th (0 … 2) of the neighbours of a zone along an axis, itself among them, or −1. Fewer than three zones are
// each looked at once.
INLINE int row_to_visit(int zone, int k, int zones, int periodic) {
  if (zones < 3) return k < zones ? k : -1;
  const int z = zone + k - 1;
  if (z >= 0 && z < zones) return z;
  return periodic ? (z < 0 ? z + zones : z - zones) : -1;
}
