// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The partners of a group: all of its particles at once against one candidate after the other. Those of a row of zones
// stand next to each other, so the neighbourhood of a stretch of a row is nine stretches of particles.
typedef struct {
  const KNOWN DenseBox* box;
  const global uint* coarse;  // dense_permute
  int padded;
  int first;  // of the group, in order of zones
  int row;    // of the group in `Found`
  coarses x, y, z;
  floats radius;
} Seekers;

// Partners of every particle of a window: near ones from the front of its row, others from the back.
typedef struct {
  int near_count[WINDOW];
  int far_count[WINDOW];
  int partners[WINDOW * MOST_PARTNERS];
  int crowded;
} Found;

INLINE void note(Found* found, int row, int partner, bool near) {
  const int near_count = found->near_count[row], far_count = found->far_count[row];
  if (near_count + far_count >= MOST_PARTNERS) {
    found->crowded = 1;
    return;
  }
  const int place = near ? near_count : MOST_PARTNERS - 1 - far_count;
  found->partners[row * MOST_PARTNERS + place] = partner;
  found->near_count[row] = near_count + (near ? 1 : 0);
  found->far_count[row] = far_count + (near ? 0 : 1);
}

// Of the candidates from `first` on, those whose bits are set in a particle's masks.
INLINE void note_all(Found* found, Seekers s, masks reached, masks close, int first) {
  uint hits[GROUP], near[GROUP];
  store_masks(hits, reached);
  store_masks(near, close);
  for (int lane = 0; lane < GROUP; ++lane)
    for (uint left = hits[lane]; left; left &= left - 1) {
      const int bit = lowest_bit(left), partner = first + bit;
      if (partner != s.first + lane) note(found, s.row + lane, partner, near[lane] >> bit & 1);
    }
}

// Among particles from … to − 1, for the particles of the group that seek: 32 candidates, then what was found.
INLINE void seek_among(Seekers s, int from, int to, masks seeking, Found* found) {
  const global uint *x = s.coarse, *y = x + s.padded, *z = y + s.padded;
  const global float* radii = (const global float*)(z + s.padded);
  const float4 metre = s.box->coarse_metre;
  const float4 near = s.box->near;
  for (int first = from; first < to; first += 32) {
    const int last = min(first + 32, to);
    masks reached = (masks)(0), close = (masks)(0);
    for (int j = first; j < last; ++j) {
      const floats dx = metres_between(s.x, x[j]) * metre.x, dy = metres_between(s.y, y[j]) * metre.y,
                   dz = metres_between(s.z, z[j]) * metre.z;
      const floats square = fma(dx, dx, fma(dy, dy, dz * dz));
      const floats reach = VARIED ? s.radius + (radii[j] + metre.w) : (floats)(near.y);
      const floats near_reach = VARIED ? reach - (metre.w - near.x) : (floats)(near.z);
      const masks bit = (masks)(1u << (j - first));
      reached |= as_masks(square < reach * reach) & bit;
      close |= as_masks(square < near_reach * near_reach) & bit;
    }
    reached &= seeking;
    if (any_of(as_marks(reached))) note_all(found, s, reached, close, first);
  }
}

// The zones from … to of a row, and those beyond its ends where it is periodic.
INLINE void seek_in_row(Seekers s, const global int* zone_starts, int row, int from, int to, masks seeking, Found* found) {
  const int zones = s.box->zones.x;
  const int low = max(from - 1, 0), high = min(to + 1, zones - 1);
  const global int* starts = zone_starts + row * zones;
  seek_among(s, starts[low], starts[high + 1], seeking, found);
  if (!s.box->periodic.x) return;
  if (from == 0 && high < zones - 1) seek_among(s, starts[zones - 1], starts[zones], seeking, found);
  if (to == zones - 1 && low > 0) seek_among(s, starts[0], starts[1], seeking, found);
}

INLINE void seek_around(Seekers s, const global int* zone_starts, int row, int from, int to, masks seeking, Found* found) {
  const int4 zones = s.box->zones, periodic = s.box->periodic;
  const int2 at = place_of_row(s.box, row);
  for (int k = 0; k < 9; ++k) {
    const int y = row_to_visit(at.x, k % 3, zones.y, periodic.y), z = row_to_visit(at.y, k / 3, zones.z, periodic.z);
    if (y >= 0 && z >= 0) seek_in_row(s, zone_starts, row_at(s.box, y, z), from, to, seeking, found);
  }
}

// A group may go across several rows; each of its particles is looked for around its own.
INLINE void seek_for_group(Seekers s, const global int* zone_starts, const global int* zones_of, Found* found) {
  const int count = min(GROUP, s.box->counts.x - s.first), across = s.box->zones.x;
  for (int from = 0, to; from < count; from = to) {
    const int row = zones_of[s.first + from] / across;
    for (to = from; to < count && zones_of[s.first + to] / across == row;) ++to;
    const masks seeking = masks_of_lanes(from, to);
    seek_around(s, zone_starts, row, zones_of[s.first + from] % across, zones_of[s.first + to - 1] % across, seeking, found);
  }
}
