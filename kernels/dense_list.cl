// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the list of a group down, and carries springs over from the list before.
typedef struct {
  const global int4* heads;
  const global uint* list;
  const global real* springs;
  const global int* strained;
  const global int* members;  // where a particle of now was then
} Former;

typedef struct {
  global int4* heads;
  global uint* list;
  global real* springs;
  global int* strained;
} Latter;

INLINE real4 spring_in(const global real* springs, int slot, int lane) {
  const global real* row = springs + (size_t)slot * (3 * GROUP) + lane;
  return (real4)(row[0], row[GROUP], row[2 * GROUP], 0);
}

INLINE void put_spring(Latter l, int slot, int lane, real4 spring) {
  if (spring.x == 0 && spring.y == 0 && spring.z == 0) return;
  global real* row = l.springs + (size_t)slot * (3 * GROUP) + lane;
  row[0] = spring.x;
  row[GROUP] = spring.y;
  row[2 * GROUP] = spring.z;
  note_strain(l.strained, slot, 1);
}

// The spring of particle `old` with partner `old_partner`, both as they stood then.
INLINE real4 former_spring(Former f, int old, int old_partner) {
  const int4 head = f.heads[old / GROUP];
  const int lane = old % GROUP;
  const uint wanted = (uint)old_partner * UNITS_A_RECORD;
  for (int k = head.x + head.w; k < head.x + head.y; ++k)
    if (may_be_strained(f.strained, k) && f.list[(size_t)k * GROUP + lane] == wanted) return spring_in(f.springs, k, lane);
  return (real4)(0);
}

// Slots of walls stand in the order of the walls near the group, then and now.
INLINE real4 former_wall_spring(Former f, int old, int wall) {
  const int4 head = f.heads[old / GROUP];
  if ((head.z >> wall & 1) == 0) return (real4)(0);
  return spring_in(f.springs, head.x + popcount(head.z & ((1 << wall) - 1)), old % GROUP);
}

INLINE void carry_group(Former f, Latter l, int4 head, int first, int count, const Found* found) {
  for (int k = head.x; k < head.x + head.y; ++k) clear_springs(l.springs, l.strained, k);
  for (int lane = 0; lane < count; ++lane) {
    const int old = f.members[first + lane];
    int k = head.x;
    for (int walls = head.z & ~(1 << FACE_BIT); walls != 0; walls &= walls - 1)
      put_spring(l, k++, lane, former_wall_spring(f, old, lowest_bit((uint)walls)));
    for (int k = 0; k < found->near_count[lane]; ++k) {
      const int partner = f.members[found->partners[lane * MOST_PARTNERS + k]];
      put_spring(l, head.x + head.w + k, lane, former_spring(f, old, partner));
    }
  }
}

// Bits of the planes that some particle of the group may touch while the list lasts, and one for the faces.
INLINE int walls_near(const global DenseBox* box, const global DensePlane* planes, const global real4* records,
                      const global int* cells, int first, int count) {
  int near = 0;
  for (int i = first; i < first + count; ++i) {
    const phase4 p = phase4_at(records, i);
    const int3 cell = cells_in(cells[i]);
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
    if ((!box->periodic.x && (x - low.x < margin || high.x - x < margin)) ||
        (!box->periodic.y && (y - low.y < margin || high.y - y < margin)) ||
        (!box->periodic.z && (z - low.z < margin || high.z - z < margin)))
      near |= 1 << FACE_BIT;
  }
  return near;
}

INLINE void write_rows(Latter l, int4 head, int first, const Found* found) {
  for (int k = 0; k < head.y; ++k) {
    global uint* row = l.list + (size_t)(head.x + k) * GROUP;
    const int place = k - head.w;
    for (int lane = 0; lane < GROUP; ++lane) {
      const int near = found->near_count[lane], all = near + found->far_count[lane];
      const int at = place < near ? place : MOST_PARTNERS - 1 - (place - near);
      const int partner = place >= 0 && place < all ? found->partners[lane * MOST_PARTNERS + at] : first + lane;
      row[lane] = (uint)partner * UNITS_A_RECORD;
    }
  }
}

// totals: slots asked for; whether some row was too short. Where in memory a group's slots lie is decided by who comes
// first, and decides nothing else.
kernel void dense_list(const global DenseBox* box, const global DensePlane* planes, const global real4* records,
                       const global int* cells, const global uint* coarse, const global int* zones_of,
                       const global int* zone_starts, const global int* members, const global int4* old_heads,
                       const global uint* old_list, const global real* old_springs, const global int* old_strained,
                       global int4* heads, global uint* list, global real* springs, global int* strained,
                       global int* totals, const int padded, const int room) {
  const int group = get_global_id(0), first = group * GROUP;
  const global uint* x = coarse + first;
  const Seekers s = {box, coarse, padded, first, load_coarses(x), load_coarses(x + padded), load_coarses(x + 2 * padded),
                     load_floats((const global float*)(x + 3 * padded))};
  const int count = clamp(box->counts.x - first, 0, GROUP);
  Found found;
  found.crowded = 0;
  for (int k = 0; k < GROUP; ++k) found.near_count[k] = found.far_count[k] = 0;
  seek_for_group(s, zone_starts, zones_of, &found);
  if (found.crowded) totals[1] = 1;
  const int near = walls_near(box, planes, records, cells, first, count);
  const int walls = HISTORY ? popcount((uint)(near & ~(1 << FACE_BIT))) : 0;
  int longest = 0;
  for (int k = 0; k < GROUP; ++k) longest = max(longest, found.near_count[k] + found.far_count[k]);
  const int slots = walls + longest;
  const int4 head = (int4)(slots > 0 ? atomic_add(totals, slots) : 0, slots, near, walls);
  heads[group] = head;
  if (head.x + slots > room) return;
  const Former former = {old_heads, old_list, old_springs, old_strained, members};
  const Latter latter = {heads, list, springs, strained};
  write_rows(latter, head, first, &found);
  if (HISTORY) carry_group(former, latter, head, first, count, &found);
}
