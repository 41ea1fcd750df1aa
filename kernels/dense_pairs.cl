// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// All that a step reads and writes. Particles stand in groups of GROUP; a group's list has a row for every slot, with
// an entry for each of its particles. Slots of walls come first, then pairs, the near ones first.
typedef struct {
  const global DenseBox* box;
  const global PairLaw* laws;
  const global DensePlane* planes;
  const global real4* records;   // QUARTERS each: phase and radius; velocity and 1/mass; angular velocity
  global real* kept;             // a group's KEPT rows
  const global phase* built_at;  // a group's 3 rows: phases when the list was built
  const global int* cells;       // of then, 10 bits an axis
  const global int4* heads;      // of a group: first slot, slots, walls near (bits), slots of walls
  const global uint* list;       // of particles, times UNITS_A_RECORD; the body itself where it has no partner
  const global real* springs;    // 3 rows a slot
  global real* new_springs;
  const global int* strained;    // of a slot: whether a spring in it may be other than zero
  global int* new_strained;
  bool keeps;                    // whether springs are to be written
} Dense;

#define DENSE_PARAMETERS                                                                                 \
  const global DenseBox *box, const global PairLaw *laws, const global DensePlane *planes,               \
      const global real4 *records, global real *kept, const global phase *built_at,                      \
      const global int *cells, const global int4 *heads, const global uint *list, const global real *springs, \
      global real *new_springs, const global int *strained, global int *new_strained
#define DENSE_THAT(keeps)                                                                               \
  {box, laws, planes, records, kept, built_at, cells, heads, list, springs, new_springs, strained, new_strained, \
   keeps}

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

INLINE Vectors load_springs(const global real* springs, int slot, int lane) {
  const global real* row = springs + (size_t)slot * (3 * GROUP) + lane;
  return vectors(load_reals(row), load_reals(row + GROUP), load_reals(row + 2 * GROUP));
}

INLINE void store_springs(global real* springs, int slot, int lane, Vectors v) {
  global real* row = springs + (size_t)slot * (3 * GROUP) + lane;
  store_reals(row, v.x);
  store_reals(row + GROUP, v.y);
  store_reals(row + 2 * GROUP, v.z);
}

// The springs of a slot in which somebody touches, before and after.
INLINE Vectors springs_before(Dense d, int slot, int lane) {
  if (!HISTORY || !may_be_strained(d.strained, slot)) return vectors(0, 0, 0);
  return load_springs(d.springs, slot, lane);
}

INLINE void keep_springs(Dense d, int slot, int lane, Vectors springs) {
  if (!HISTORY || !d.keeps) return;
  store_springs(d.new_springs, slot, lane, springs);
  note_strain(d.new_strained, slot, 1);
}

INLINE void release_springs(Dense d, int slot, int lane) {
  if (!HISTORY || !d.keeps || !may_be_strained(d.strained, slot)) return;
  store_springs(d.new_springs, slot, lane, vectors(0, 0, 0));
  note_strain(d.new_strained, slot, 0);
}

// Sums over the partners in one slot. Tells whether one overlaps too much.
INLINE bool meet_slot(Dense d, Push* total, Bodies b, int slot, PairLaw law, real duration) {
  const global uint* entry = d.list + (size_t)slot * GROUP + b.lane;
  const Quarter at = fetch(d.records, entry, 0);
  const phases x = b.x - phases_of(at.x), y = b.y - phases_of(at.y), z = b.z - phases_of(at.z);
  const Vectors apart = vectors(to_reals(x) * d.box->metre.x, to_reals(y) * d.box->metre.y, to_reals(z) * d.box->metre.z);
  const reals square = inner(apart, apart);
  const phases sum_phase = b.radius_phase + phases_of(at.w);
  const lengths sum = VARIED ? length_in(sum_phase, d.box->quantum.w) : (lengths)(d.box->alike.x);
  const reals sigma = rounded(sum);
  Meeting m;
  m.touching = (square < sigma * sigma * d.box->limits.z) & different(load_entries(entry), b.index * UNITS_A_RECORD);
  if (!any_of(m.touching)) {
    release_springs(d, slot, b.lane);
    return false;
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
    m.sweep = plus_scaled(scaled(b.spin, m.arm), xyz_of(fetch(d.records, entry, 2)),
                          arm_of(radius, m.overlap, law.history));
  Vectors spring = springs_before(d, slot, b.lane);
  push(total, m, law, &spring, duration);
  keep_springs(d, slot, b.lane, spring);
  return any_of(m.overlap > d.box->limits.x * (radius < b.radius ? radius : b.radius));
}

INLINE bool meet_pairs(Dense d, Push* total, Bodies b, real duration) {
  const int own = d.box->counts.w;
  PairLaw law = d.laws[own * d.box->counts.z + own];
  law.history = HISTORY_VARIANT;
  const int4 head = d.heads[b.group];
  bool too_deep = false;
  for (int k = head.w; k < head.y; ++k) too_deep |= meet_slot(d, total, b, head.x + k, law, duration);
  return too_deep;
}
