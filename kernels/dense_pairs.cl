// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// All that a step reads and writes. Particles stand in groups of GROUP; a group's list has a row for every slot, with
// an entry for each of its particles. Slots of walls come first, then pairs, the near ones first.
typedef struct {
  const KNOWN DenseBox* box;
  const global PairLaw* laws;
  const global DensePlane* planes;
  const global real4* records;   // QUARTERS each: phase and radius; velocity and 1/mass; angular velocity
  global real* kept;             // a group's KEPT rows
  const global phase* built_at;  // a group's 3 rows: phases when the list was built
  const global int* cells;       // of then, 10 bits an axis
  const global int4* heads;      // of a group: first slot, slots, walls near (bits), slots of walls
  const global uint* list;       // of particles, times UNITS_A_RECORD; the body itself where it has no partner
  const global real* springs;    // dense_springs.cl
  global real* new_springs;
  const global int* marks;
  global int* new_marks;
  global int* taken;             // rows of springs, and how many there are
  bool keeps;                    // whether springs are to be written
} Dense;

#define DENSE_PARAMETERS                                                                                 \
  const KNOWN DenseBox *box, const global PairLaw *laws, const global DensePlane *planes,               \
      const global real4 *records, global real *kept, const global phase *built_at,                      \
      const global int *cells, const global int4 *heads, const global uint *list, const global real *springs, \
      global real *new_springs, const global int *marks, global int *new_marks
#define DENSE_THAT(keeps)                                                                               \
  {box, laws, planes, records, kept, built_at, cells, heads, list, springs, new_springs, marks, new_marks, \
   signals + ROWS_TAKEN, keeps}

// LANES particles, and where they are.
typedef struct {
  int first;
  int group;
  int lane;
  indices index;
  phases x, y, z;
  phases radius_phase;
  Vectors velocity, spin;
  reals inverse_mass, radius;
  flags moves;
} Bodies;

INLINE Bodies load_bodies(Dense d, int item) {
  Bodies b;
  b.first = item * LANES;
  b.group = b.first / GROUP;
  b.lane = b.first % GROUP;
  b.index = lanes_from(b.first);
  const Quarter at = fetch_own(d.records, b.first, 0), motion = fetch_own(d.records, b.first, 1);
  b.x = phases_of(at.x);
  b.y = phases_of(at.y);
  b.z = phases_of(at.z);
  b.radius_phase = phases_of(at.w);
  b.velocity = xyz_of(motion);
  b.spin = vectors(0, 0, 0);
  if (ROTATION) b.spin = xyz_of(fetch_own(d.records, b.first, 2));
  b.inverse_mass = VARIED ? motion.w : (reals)(d.box->body.y);
  b.radius = VARIED ? to_reals(b.radius_phase) * d.box->metre.w : (reals)(d.box->body.x);
  b.moves = below(b.index, d.box->counts.x);
  if (VARIED) b.moves = b.moves & (b.inverse_mass > 0);
  return b;
}

// Rounded alike for both bodies of a pair, so that the spring of one is the other's, turned around.
INLINE Vectors sweeps_of(Vectors a, reals arm, Vectors b, reals other_arm) {
  if (!VARIED) return scaled(plus_scaled(a, b, (reals)(1)), arm);
  return plus_scaled(scaled(a, arm), scaled(b, other_arm), (reals)(1));
}

// The springs of a slot in which somebody touches, before and after. place: of its mark.
INLINE Vectors springs_before(Dense d, int mark) {
  if (!HISTORY || !is_strained(mark)) return vectors(0, 0, 0);
  const global real* row = d.springs + row_of(mark);
  return vectors(load_reals(row), load_reals(row + GROUP), load_reals(row + 2 * GROUP));
}

INLINE void keep_springs(Dense d, size_t place, int mark, Vectors springs) {
  if (!HISTORY || !d.keeps || !has_row(mark)) return;
  global real* row = d.new_springs + row_of(mark);
  store_reals(row, springs.x);
  store_reals(row + GROUP, springs.y);
  store_reals(row + 2 * GROUP, springs.z);
  d.new_marks[place] = mark | 1;
}

INLINE void release_springs(Dense d, size_t place, int mark) {
  if (HISTORY && d.keeps && is_strained(mark)) d.new_marks[place] = mark & ~1;
}

#define OVERLAPS_TOO_MUCH 1
#define ROWS_ARE_SHORT 2

// Rows are given before anybody touches: no two bodies come closer by `approach` in a step, dense_step.cl. Where none
// is left, the next list has more.
INLINE int give_row(Dense d, size_t place, int* mark) {
  const int row = atomic_inc(d.taken);
  if (row >= d.taken[1]) return ROWS_ARE_SHORT;
  *mark = d.new_marks[place] = mark_of_row(row);
  return 0;
}

// Sums over the partners in one slot. Tells what must be heard of.
INLINE int meet_slot(Dense d, Push* total, Bodies b, int slot, PairLaw law, real duration) {
  const global uint* entry = d.list + (size_t)slot * GROUP + b.lane;
  const Quarter at = fetch(d.records, entry, 0);
  const phases x = b.x - phases_of(at.x), y = b.y - phases_of(at.y), z = b.z - phases_of(at.z);
  const Vectors apart = vectors(to_reals(x) * d.box->metre.x, to_reals(y) * d.box->metre.y, to_reals(z) * d.box->metre.z);
  const reals square = inner(apart, apart);
  const phases sum_phase = b.radius_phase + phases_of(at.w);
  const lengths sum = VARIED ? length_in(sum_phase, d.box->quantum.w) : (lengths)(d.box->alike.x);
  const reals sigma = rounded(sum);
  const flags other = different(load_entries(entry), b.index * UNITS_A_RECORD);
  const size_t place = mark_at(slot, b.lane);
  int mark = HISTORY ? d.marks[place] : 0;
  Meeting m;
  m.touching = (square < sigma * sigma * d.box->limits.z) & other;
  const bool looks_ahead = HISTORY && d.keeps && !has_row(mark);
  const reals wide = sigma + (looks_ahead ? (real)d.box->near.w : (real)0);
  if (!any_of(looks_ahead ? (square < wide * wide) & other : m.touching)) {
    release_springs(d, place, mark);
    return 0;
  }
  int heard = 0;
  if (looks_ahead) {
    heard = give_row(d, place, &mark);
    if (!any_of(m.touching)) return heard;
  }
  const Quarter motion = fetch(d.records, entry, 1);
  const reals gap = square_gap(x, y, z, d.box->quantum, sum);
  m.touching = m.touching & (gap > 0);
  if (VARIED) m.touching = m.touching & (b.inverse_mass + motion.w > 0);
  const reals distance = roots_of(m.touching ? square : (reals)(1)), reach = distance + sigma;
  const reals inverse = 1 / (distance * reach);
  m.overlap = m.touching ? gap * distance * inverse : (reals)(0);
  m.normal = scaled(apart, reach * inverse);
  m.velocity = less(b.velocity, xyz_of(motion));
  m.root_mass = VARIED ? roots_of(1 / (b.inverse_mass + motion.w)) : (reals)(d.box->body.w);
  m.arm = arm_of(b.radius, m.overlap, law.history);
  const reals radius = VARIED ? to_reals(phases_of(at.w)) * d.box->metre.w : (reals)(d.box->body.x);
  m.sweep = b.spin;
  if (ROTATION)
    m.sweep = sweeps_of(b.spin, m.arm, xyz_of(fetch(d.records, entry, 2)), arm_of(radius, m.overlap, law.history));
  Vectors spring = springs_before(d, mark);
  push(total, m, law, &spring, duration);
  keep_springs(d, place, mark, spring);
  const bool too_deep = any_of(m.overlap > d.box->limits.x * (radius < b.radius ? radius : b.radius));
  return heard | (too_deep ? OVERLAPS_TOO_MUCH : 0);
}

INLINE int meet_pairs(Dense d, Push* total, Bodies b, real duration) {
  const int own = d.box->counts.w;
  PairLaw law = d.laws[own * d.box->counts.z + own];
  law.history = HISTORY_VARIANT;
  const int4 head = d.heads[b.group];
  int heard = 0;
  for (int k = head.w; k < head.y; ++k) heard |= meet_slot(d, total, b, head.x + k, law, duration);
  return heard;
}
