// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the lists of a window down, and carries springs over from the list before.

// A window in the order in which it was searched, and in which it will stand: those with alike counts next to each
// other, so that slots are full.
INLINE void order_window(const Found* found, int count, int* order) {
  int starts[BUCKETS + 1];
  for (int k = 0; k <= BUCKETS; ++k) starts[k] = 0;
  for (int i = 0; i < count; ++i) ++starts[bucket_of(found->near_count[i], found->far_count[i]) + 1];
  for (int k = 0; k < BUCKETS; ++k) starts[k + 1] += starts[k];
  for (int i = 0; i < count; ++i) order[starts[bucket_of(found->near_count[i], found->far_count[i])]++] = i;
  for (int i = count; i < WINDOW; ++i) order[i] = i;
}

// Of the particle in row `row` of what was found, into lane `lane` of slots from head.x on.
INLINE void write_lane(Latter l, int4 head, int lane, int self, int row, const Found* found) {
  const int near = found->near_count[row], all = near + found->far_count[row];
  const int* partners = found->partners + row * MOST_PARTNERS;
  global uint* entry = l.list + (size_t)head.x * GROUP + lane;
  for (int k = 0; k < head.y; ++k, entry += GROUP) {
    const int place = k - head.w;
    *entry = (uint)(place < 0 || place >= all ? self : partners[place < near ? place : MOST_PARTNERS - 1 - (place - near)]);
  }
}

INLINE void carry_lane(Former f, Latter l, int4 head, int lane, int self, int row, const Found* found) {
  const int old = f.members[self];
  int k = head.x;
  for (int walls = head.z & ~(1 << FACE_BIT); walls != 0; walls &= walls - 1)
    put_spring(l.springs, l.marks + k++, lane, former_spring(f, old, WALL_PARTNER | (uint)lowest_bit((uint)walls), 1));
  const int* partners = found->partners + row * MOST_PARTNERS;
  for (int near = 0; near < found->near_count[row]; ++near)
    put_spring(l.springs, l.marks + k++, lane, spring_between(f, old, f.members[partners[near]]));
}

// Who is in touch, with its spring: only near partners have room for one.
INLINE void carry_touch(Former f, Latter l, int slot, int rows, int lane, int old, uint partner) {
  const int place = place_packed(f, old, partner);
  if (place < 0) return;
  l.marks[touch_at(slot, lane)] |= 1 << lane;
  if (HISTORY && rows > 0) put_spring(l.springs, l.marks + mark_at(slot, lane), lane, former_spring(f, old, partner, 1));
}

INLINE void carry_touches(Former f, Latter l, int4 head, int lane, int self, int row, const Found* found) {
  const int old = f.members[self], near = found->near_count[row], all = near + found->far_count[row];
  if (f.starts[old] < 0) return;
  int slot = head.x;
  for (int walls = head.z & ~(1 << FACE_BIT); walls != 0; walls &= walls - 1)
    carry_touch(f, l, slot++, 1, lane, old, WALL_PARTNER | (uint)lowest_bit((uint)walls));
  const int* partners = found->partners + row * MOST_PARTNERS;
  for (int k = 0; k < all; ++k) {
    const int partner = partners[k < near ? k : MOST_PARTNERS - 1 - (k - near)];
    carry_touch(f, l, slot++, near - k, lane, old, (uint)f.members[partner] + 1);
  }
}

// The first `rows` slots of a group have rows for springs.
INLINE void mark_slots(global int* marks, int4 head, int rows, int first_row) {
  for (int k = 0; k < head.y; ++k) {
    if (HISTORY) marks[mark_at(head.x + k, 0)] = k < rows ? mark_of_row(first_row + k) : 0;
    if (CORRECTED) marks[touch_at(head.x + k, 0)] = 0;
  }
}

// Particles order[0 … GROUP − 1] of the window that begins at `first`. near: most near partners of one of them.
INLINE int4 head_of(Site s, int first, const int* order, const Found* found, global int* totals, int* near) {
  int planes = 0, longest = 0;
  *near = 0;
  for (int lane = 0; lane < GROUP; ++lane) {
    const int self = first + order[lane], old = s.members[self];
    if (self < s.box->counts.x)
      planes |= walls_near(s.box, s.planes, phase4_at(s.records, old), cells_in(s.cells[old]));
    *near = max(*near, found->near_count[order[lane]]);
    longest = max(longest, found->near_count[order[lane]] + found->far_count[order[lane]]);
  }
  const int walls = HISTORY || CORRECTED ? popcount((uint)(planes & ~(1 << FACE_BIT))) : 0;
  const int slots = walls + longest;
  return (int4)(slots > 0 ? atomic_add(totals + SLOTS_WANTED, slots) : 0, slots, planes, walls);
}

INLINE void seek_for_window(const KNOWN DenseBox* box, const global uint* coarse, int padded, int first,
                            const global int* zone_starts, const global int* zones_of, Found* found) {
  found->crowded = 0;
  for (int k = 0; k < WINDOW; ++k) found->near_count[k] = found->far_count[k] = 0;
  for (int row = 0; row < WINDOW; row += GROUP) {
    const global uint* x = coarse + first + row;
    const Seekers s = {box, coarse, padded, first + row, row, load_coarses(x), load_coarses(x + padded),
                       load_coarses(x + 2 * padded), load_floats((const global float*)(x + 3 * padded))};
    seek_for_group(s, zone_starts, zones_of, found);
  }
}

// One window of WINDOW particles in order of zones. totals: slots asked for; whether some row was too short; rows of
// springs asked for. Where in memory a group's slots lie is decided by who comes first, and decides nothing else.
// Partners are named by their place in the order of zones; dense_rename.
kernel void dense_list(const KNOWN DenseBox* box, const global DensePlane* planes, const global real4* records,
                       const global int* cells, const global uint* coarse, const global int* zones_of,
                       const global int* zone_starts, const global int* members, const global int* starts,
                       const global uint* partners, const global real* packed, global int4* heads, global uint* list,
                       global real* springs, global int* marks, global int* order, global int* places,
                       global int* totals, const int padded, const int room, const int row_room) {
  const int first = get_global_id(0) * WINDOW, count = clamp(box->counts.x - first, 0, WINDOW);
  Found found;
  seek_for_window(box, coarse, padded, first, zone_starts, zones_of, &found);
  if (found.crowded) totals[CROWDED] = 1;
  int rows[WINDOW];
  order_window(&found, count, rows);
  for (int i = 0; i < WINDOW; ++i) {
    order[first + i] = first + rows[i];
    places[first + rows[i]] = first + i;
  }
  const Site site = {box, planes, records, cells, members};
  const Former former = {starts, partners, packed, members};
  const Latter latter = {heads, list, springs, marks};
  for (int g = 0; g < WINDOW; g += GROUP) {
    int near;
    const int4 head = head_of(site, first, rows + g, &found, totals, &near);
    heads[(first + g) / GROUP] = head;
    const int wanted = head.w + near, first_row = HISTORY && wanted > 0 ? atomic_add(totals + ROWS_WANTED, wanted) : 0;
    if (head.x + head.y > room || first_row + (HISTORY ? wanted : 0) > row_room) continue;
    mark_slots(marks, head, wanted, first_row);
    for (int lane = 0; lane < GROUP; ++lane) {
      const int row = rows[g + lane];
      write_lane(latter, head, lane, first + row, row, &found);
      if (row >= count) continue;
      if (CORRECTED)
        carry_touches(former, latter, head, lane, first + row, row, &found);
      else if (HISTORY)
        carry_lane(former, latter, head, lane, first + row, row, &found);
    }
  }
}

// From the order of zones, in which the list was found, to where particles are now.
kernel void dense_rename(const global int4* heads, const global int* places, global uint* list) {
  const int4 head = heads[get_global_id(0)];
  global uint* row = list + (size_t)head.x * GROUP;
  for (int k = 0; k < head.y * GROUP; ++k) row[k] = (uint)places[row[k]] * UNITS_A_RECORD;
}
