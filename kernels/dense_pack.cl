// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Packs the springs of a list, before it is given up: dense_springs.cl.
typedef struct {
  const global uint* list;
  const global real* springs;
  const global int* marks;
  int4 head;
} Strained;

// Who is at the other end of the spring in a slot, if it is other than zero and this particle's to keep; else 0, which
// is no partner: nobody stands before the first.
INLINE uint partner_to_pack(Strained s, int k, int self, int lane, int* walls) {
  const int slot = s.head.x + k, mark = HISTORY ? s.marks[mark_at(slot, lane)] : 0;
  uint partner = WALL_PARTNER;
  if (k < s.head.w) {
    partner |= (uint)lowest_bit((uint)*walls);
    *walls &= *walls - 1;
  }
  if (CORRECTED && (s.marks[touch_at(slot, lane)] >> lane & 1) == 0) return 0;
  if (!CORRECTED && (!is_strained(mark) || is_zero(spring_in(s.springs, mark, lane)))) return 0;
  if (k < s.head.w) return partner;
  partner = s.list[(size_t)slot * GROUP + lane] / UNITS_A_RECORD;
  // Nobody stands before the first, so that 0 is free to say: no partner. One that is corrected is told of by one more.
  if (CORRECTED) return partner + 1;
  return partner > (uint)self ? partner : 0;
}

INLINE int springs_to_pack(Strained s, int self, int lane) {
  int count = 0, walls = s.head.z & ~(1 << FACE_BIT);
  for (int k = 0; k < s.head.y; ++k) count += partner_to_pack(s, k, self, lane, &walls) != 0;
  return count;
}

INLINE void pack_lane(Strained s, int self, int lane, int at, global uint* partners, global real* packed) {
  int walls = s.head.z & ~(1 << FACE_BIT), last = -1;
  for (int k = 0; k < s.head.y; ++k) {
    const uint partner = partner_to_pack(s, k, self, lane, &walls);
    if (partner == 0) continue;
    partners[at] = partner;
    last = at++;
    if (!HISTORY) continue;
    const int mark = s.marks[mark_at(s.head.x + k, lane)];
    const real4 spring = is_strained(mark) ? spring_in(s.springs, mark, lane) : (real4)(0);
    packed[3 * last] = spring.x;
    packed[3 * last + 1] = spring.y;
    packed[3 * last + 2] = spring.z;
  }
  if (last >= 0) partners[last] |= LAST_PARTNER;
}

kernel void dense_pack(const global int4* heads, const global uint* list, const global real* springs,
                       const global int* marks, global int* starts, global uint* partners, global real* packed,
                       global int* totals, const int room) {
  const int first = get_global_id(0) * LANES, lane = first % GROUP;
  const Strained s = {list, springs, marks, heads[first / GROUP]};
  int counts[LANES], all = 0;
  for (int k = 0; k < LANES; ++k) all += counts[k] = springs_to_pack(s, first + k, lane + k);
  int at = all > 0 ? atomic_add(totals + SPRINGS_PACKED, all) : 0;
  const bool fits = at + all <= room;
  for (int k = 0; k < LANES; at += counts[k++]) {
    starts[first + k] = counts[k] > 0 ? at : -1;
    if (fits && counts[k] > 0) pack_lane(s, first + k, lane + k, at, partners, packed);
  }
}
