// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Puts the particles in order of zones, and within a zone in the order they had.
INLINE phase4 phase4_at(const global real4* records, int i) { return phase4_of(records[i * QUARTERS]); }

INLINE const global phase* built_row(const global phase* rows, int i) {
  return rows + (size_t)(i / GROUP) * (3 * GROUP) + i % GROUP;
}

// A phase that has wrapped since `then` has entered the next cell, or the one before.
INLINE int cell_after(int cell, phase now, phase then, int cells, int periodic) {
  const phase moved = (phase)((bare_phase)now - (bare_phase)then);
  int next = cell;
  if (moved >= 0 && (bare_phase)now < (bare_phase)then) ++next;
  if (moved < 0 && (bare_phase)now > (bare_phase)then) --next;
  if (!periodic) return clamp(next, 0, cells - 1);
  return next < 0 ? next + cells : (next >= cells ? next - cells : next);
}

// Of the whole extent along an axis, in units of 2^-32.
INLINE uint coarse_along(int cell, phase p, double coarse) {
  const double at = ((double)cell + (double)(bare_phase)p * (PHASE_BITS == 32 ? 0x1p-32 : 0x1p-64)) * coarse;
  return at < 4294967295.0 ? (uint)at : 4294967295u;
}

INLINE int3 cells_in(int packed) { return (int3)(packed & 1023, packed >> 10 & 1023, packed >> 20 & 1023); }

// Rows of zones lie along x, some abreast in a band along z, and band after band: who is met in the next row or layer
// was met a short while ago, and is still in a cache, in a box of any width.
INLINE int row_at(const KNOWN DenseBox* box, int y, int z) {
  const int first = y / box->periodic.w * box->periodic.w, width = min(box->periodic.w, box->zones.y - first);
  return first * box->zones.z + z * width + y - first;
}

// y and z.
INLINE int2 place_of_row(const KNOWN DenseBox* box, int row) {
  const int first = row / (box->periodic.w * box->zones.z) * box->periodic.w;
  const int width = min(box->periodic.w, box->zones.y - first), within = row - first * box->zones.z;
  return (int2)(first + within % width, within / width);
}

INLINE int dense_zone(const KNOWN DenseBox* box, uint x, uint y, uint z) {
  const int4 n = box->zones;
  return row_at(box, (int)mul_hi(y, (uint)n.y), (int)mul_hi(z, (uint)n.z)) * n.x + (int)mul_hi(x, (uint)n.x);
}

kernel void dense_zone_clear(global int* zone_counts, const int zones) {
  const int i = get_global_id(0);
  if (i < zones) zone_counts[i] = 0;
}

kernel void dense_zone_count(const KNOWN DenseBox* box, const global real4* records, const global phase* built_at,
                             global int* cells, global int* zone_counts, global int* zone_of_particle) {
  const int i = get_global_id(0);
  if (i >= box->counts.x) return;
  const phase4 p = phase4_at(records, i);
  const global phase* then = built_row(built_at, i);
  const int3 old = cells_in(cells[i]);
  const int x = cell_after(old.x, p.x, then[0], box->cells.x, box->periodic.x);
  const int y = cell_after(old.y, p.y, then[GROUP], box->cells.y, box->periodic.y);
  const int z = cell_after(old.z, p.z, then[2 * GROUP], box->cells.z, box->periodic.z);
  cells[i] = x | y << 10 | z << 20;
  const double4 coarse = box->coarse;
  const int zone = dense_zone(box, coarse_along(x, p.x, coarse.x), coarse_along(y, p.y, coarse.y),
                              coarse_along(z, p.z, coarse.z));
  zone_of_particle[i] = zone;
  atomic_inc(&zone_counts[zone]);
}

kernel void dense_zone_fill(const global int* zone_of_particle, const global int* zone_starts, global int* zone_counts,
                            global int* members, const int particles) {
  const int i = get_global_id(0);
  if (i >= particles) {
    members[i] = i;
    return;
  }
  const int zone = zone_of_particle[i];
  members[zone_starts[zone] + atomic_dec(&zone_counts[zone]) - 1] = i;
}

kernel void dense_zone_order(const global int* zone_starts, global int* members, const int zones) {
  const int zone = get_global_id(0);
  if (zone >= zones) return;
  sort_few(members + zone_starts[zone], zone_starts[zone + 1] - zone_starts[zone]);
}

// What a search looks at, in order of zones. coarse: four rows of all particles: where each is, and its radius.
kernel void dense_coarse(const KNOWN DenseBox* box, const global int* members, const global int* zone_of_particle,
                         const global real4* records, const global int* cells, global int* zones_of,
                         global uint* coarse, const int padded) {
  const int i = get_global_id(0), old = members[i];
  zones_of[i] = i < box->counts.x ? zone_of_particle[old] : 0;
  const phase4 p = phase4_at(records, old);
  const int3 cell = cells_in(cells[old]);
  coarse[i] = coarse_along(cell.x, p.x, box->coarse.x);
  coarse[padded + i] = coarse_along(cell.y, p.y, box->coarse.y);
  coarse[2 * padded + i] = coarse_along(cell.z, p.z, box->coarse.z);
  coarse[3 * padded + i] = as_uint((float)p.w * (float)box->quantum.w);
}

// order: which of the order of zones stands at a place; members: where that one stood before.
kernel void dense_permute(const global int* order, const global int* members, const global real4* records,
                          global real4* new_records) {
  const int i = get_global_id(0), old = members[order[i]];
  for (int q = 0; q < QUARTERS; ++q) new_records[i * QUARTERS + q] = records[old * QUARTERS + q];
}

kernel void dense_permute_rest(const global int* order, const global int* members, const global real* kept,
                               const global int* ids, const global int* cells, global real* new_kept,
                               global int* new_ids, global int* new_cells) {
  const int i = get_global_id(0), old = members[order[i]];
  const size_t from = (size_t)(old / GROUP) * (KEPT * GROUP) + old % GROUP;
  const size_t to = (size_t)(i / GROUP) * (KEPT * GROUP) + i % GROUP;
  for (int k = 0; k < KEPT; ++k) new_kept[to + k * GROUP] = kept[from + k * GROUP];
  new_ids[i] = ids[old];
  new_cells[i] = cells[old];
}

// What has been permuted into room that is wanted again goes where it belongs.
kernel void dense_settle(const global real4* records, const global real* new_kept, const global int* new_ids,
                         const global int* new_cells, global real* kept, global int* ids, global int* cells,
                         global phase* built_at) {
  const int i = get_global_id(0);
  const size_t at = (size_t)(i / GROUP) * (KEPT * GROUP) + i % GROUP;
  for (int k = 0; k < KEPT; ++k) kept[at + k * GROUP] = new_kept[at + k * GROUP];
  ids[i] = new_ids[i];
  cells[i] = new_cells[i];
  const phase4 p = phase4_at(records, i);
  global phase* then = built_at + (size_t)(i / GROUP) * (3 * GROUP) + i % GROUP;
  then[0] = p.x;
  then[GROUP] = p.y;
  then[2 * GROUP] = p.z;
}
