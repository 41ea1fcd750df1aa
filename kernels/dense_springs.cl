// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Where springs lie. A span is the particles of a group that one work-item has, and their springs in a slot are a row
// for each axis. Only those spans have rows in which somebody touches, or soon may. Of a span in a slot there is a mark:
// 0 where it has none, else twice one more than where they are, and one on top where a spring in them is other than
// zero; else they hold nothing of use. Rows of as many spans as a group has stand side by side. Where contacts are
// corrected there is a second word: bits of those that were in touch at the last boundary.
#define SPANS (GROUP / LANES)
#define MARK_WORDS (HISTORY + CORRECTED)
INLINE size_t mark_at(int slot, int lane) { return ((size_t)slot * SPANS + lane / LANES) * MARK_WORDS; }
INLINE size_t touch_at(int slot, int lane) { return mark_at(slot, lane) + HISTORY; }

INLINE bool has_row(int mark) { return mark != 0; }
INLINE bool is_strained(int mark) { return (mark & 1) != 0; }
INLINE int mark_of_row(int row) { return 2 * (row + 1); }
INLINE size_t row_of(int mark) {
  const int row = mark / 2 - 1;
  return (size_t)(row / SPANS) * (3 * GROUP) + row % SPANS * LANES;
}

// In `signals`, behind the two sets of them.
#define ROWS_TAKEN 8
// In `totals` of a list that is made.
#define SLOTS_WANTED 0
#define CROWDED 1
#define ROWS_WANTED 2
#define SPRINGS_PACKED 3

// While a list is made, springs other than zero are packed: those of a particle one after the other, with a pair's kept
// by the one that stands first. The last one of a particle is marked; a particle without has no start. Where contacts
// are corrected, all that are in touch are packed, by both.
#define WALL_PARTNER 0x40000000u
#define LAST_PARTNER 0x80000000u

typedef struct {
  const global int* starts;
  const global uint* partners;
  const global real* packed;
  const global int* members;  // where a particle of now was then
} Former;

INLINE real4 spring_in(const global real* springs, int mark, int lane) {
  const global real* row = springs + row_of(mark) + lane % LANES;
  return (real4)(row[0], row[GROUP], row[2 * GROUP], 0);
}

INLINE int lowest_bit(uint bits) { return 31 - (int)clz(bits & -bits); }

INLINE bool is_zero(real4 spring) { return spring.x == 0 && spring.y == 0 && spring.z == 0; }

INLINE void put_spring(global real* springs, global int* mark, int lane, real4 spring) {
  if (is_zero(spring)) return;
  global real* row = springs + row_of(*mark);
  if (!is_strained(*mark))
    for (int k = 0; k < 3 * LANES; ++k) row[k / LANES * GROUP + k % LANES] = 0;
  row += lane % LANES;
  row[0] = spring.x;
  row[GROUP] = spring.y;
  row[2 * GROUP] = spring.z;
  *mark |= 1;
}

// Below 0 where there is none.
INLINE int place_packed(Former f, int old, uint partner) {
  int k = f.starts[old];
  if (k < 0) return k;
  for (;; ++k) {
    const uint at = f.partners[k];
    if ((at & ~LAST_PARTNER) == partner) return k;
    if (at & LAST_PARTNER) return -1;
  }
}

INLINE real4 former_spring(Former f, int old, uint partner, real sign) {
  const int k = place_packed(f, old, partner);
  if (k < 0) return (real4)(0);
  return (real4)(sign * f.packed[3 * k], sign * f.packed[3 * k + 1], sign * f.packed[3 * k + 2], 0);
}

// Of `old`; both as they stood then.
INLINE real4 spring_between(Former f, int old, int partner) {
  return former_spring(f, min(old, partner), (uint)max(old, partner), old < partner ? (real)1 : (real)-1);
}
