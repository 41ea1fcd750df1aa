// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// All that a step reads and writes. Particles stand in groups of GROUP; a group's list has a row for every slot, with
// an entry for each of its particles. Slots of walls come first, then pairs, the near ones first.
typedef struct {
  const KNOWN DenseBox* box;
  const global PairLaw* laws;
  const global DensePlane* planes;
  const global real4* records;   // QUARTERS each: phase and radius; velocity and 1/mass; angular velocity; of the middle
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

// Quarters of a record in which velocity and spin in the middle of the step are. Where bodies are all alike, the spin has
// the fourth places of the quarters before: a record is a cache line then, in single precision.
#define MIDDLE (2 + ROTATION)
#define MIDDLE_SPIN_APART (PREDICTED && ROTATION && VARIED)
#define MIDDLE_SPIN_PACKED (PREDICTED && ROTATION && VARIED == 0)

// LANES particles, and where they are.
typedef struct {
  int first;
  int group;
  int lane;
  indices index;
  phases x, y, z;
  phases radius_phase;
  Vectors velocity, spin;                // that forces take
  Vectors middle_velocity, middle_spin;  // in the middle of the step that has led here
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
  const Quarter none = {0, 0, 0, 0}, turning = ROTATION ? fetch_own(d.records, b.first, 2) : none;
  b.spin = xyz_of(turning);
  const Quarter middle = PREDICTED ? fetch_own(d.records, b.first, MIDDLE) : none;
  b.middle_velocity = PREDICTED ? xyz_of(middle) : b.velocity;
  b.middle_spin = PREDICTED ? vectors(motion.w, turning.w, middle.w) : b.spin;
  if (MIDDLE_SPIN_APART) b.middle_spin = xyz_of(fetch_own(d.records, b.first, MIDDLE + 1));
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

INLINE reals inverse_inertia_of(Dense d, reals inverse_mass, reals radius) {
  return VARIED ? (real)2.5f * inverse_mass / (radius * radius) : (reals)(d.box->body.z);
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

// Who was in touch at the last boundary, kept as bits behind the mark.
INLINE int touched_before(Dense d, size_t place) { return CORRECTED ? d.marks[place + HISTORY] : 0; }
INLINE flags flags_in(int bits, int lane) {
  return different(((indices)(bits) >> lanes_from(lane)) & 1, (indices)(0));
}
INLINE void note_touches(Dense d, size_t place, int before, flags touching) {
  const int now = bits_of(touching);
  if (d.keeps && now != before) d.new_marks[place + HISTORY] = now;
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

INLINE real alike_refinement(real mobility, real stiffness, real damping, real step) {
  const real braked = 1 + (real)0.5f * step * mobility * damping;
  return braked / (braked + (real)0.5f * step * step * mobility * stiffness);
}

INLINE Untrue alike_untrue(real mobility, real stiffness, real damping, real step) {
  const real braked = (real)0.5f * step * mobility * damping, swings = (real)0.25f * step * step * mobility * stiffness;
  const real refined = alike_refinement(mobility, stiffness, damping, step);
  const Untrue u = {refined - (1 - swings) / (1 + braked), (swings - braked) / (1 + braked)};
  return u;
}

INLINE Alike alike_of(Dense d, PairLaw law, real step) {
  const real4 body = d.box->body;
  const real along = 2 * body.y, across = along + (ROTATION ? 2 * body.x * body.x * body.z : 0);
  const real damping = law.damping + law.damping_root_mass * body.w;
  const real spring_damping = law.spring_damping + law.spring_damping_root_mass * body.w;
  Alike a;
  a.mobility = across;
  a.rate = alike_refinement(along, law.stiffness, damping, step);
  a.slip = alike_refinement(across, law.spring, spring_damping, step);
  a.untrue_rate = alike_untrue(along, law.stiffness, damping, step);
  a.untrue_slip = alike_untrue(across, law.spring, spring_damping, step);
  return a;
}

// Contacts act, those that begin or end for as long as they last.
INLINE void press(Dense d, Push* total, Meeting m, flags was, Happening h, PairLaw law, Vectors* spring, real duration) {
  if (CORRECTED) m.lasts = duration > 0 ? m.touching & was : m.touching & ~m.touching;
  Onset o;
  if (h.event) o = onset_of(&m, was, law, spring, duration, d.box->zones.w);
  Vectors rub = m.normal;
  if (h.turned) rub = turn_over(&m, h.turns, law, spring, duration);
  const Grasp g = push(total, m, law, spring, duration);
  if (h.event) correct(total, m, o, g, duration);
  if (h.turned) end_turnover(total, m, h.turns, rub, g, law, duration);
}

// By the slip in the middle of the step, multiplied out (integrators.12): spheres that roll round each other have another
// normal there. `turn` is half a step over their distance.
INLINE void stretch_by_middles(Meeting* m, reals turn) {
  const Vectors v = m->middle_velocity, normal = m->normal;
  const reals separating = inner(v, normal);
  m->around = plus_scaled(v, normal, -separating);
  m->turn = turn;
  m->closer = turn * inner(m->around, m->around);
  m->stretching = scaled(m->around, fma(turn, separating - m->closer, (reals)(1)));
  if (!ROTATION) return;
  const Vectors sweep = plus_scaled(m->middle_sweep, m->around, turn * inner(m->middle_sweep, normal));
  m->stretching = less(m->stretching, outer(sweep, normal));
}

// What contacts leave of predicted rates and slips.
INLINE void foresee(Meeting* m, reals mobility, PairLaw law, Alike alike, real duration) {
  m->alike = alike;
  m->foreseen = alike.rate;
  m->foreseen_slip = alike.slip;
  if (VARIED) m->foreseen = refinement(duration, mobility, law.stiffness, dashpot_of(law, m->root_mass));
  if (!ALL_ALIKE)
    m->foreseen_slip = refinement(duration, m->mobility, law.spring, spring_dashpot_of(law, m->root_mass));
}

// How bodies that stand at an overlap move against each other, the partners in `entry`.
INLINE void compare_motion(Meeting* m, Bodies b, Quarter motion, Quarter turning, reals other_arm) {
  m->velocity = less(b.velocity, xyz_of(motion));
  m->sweep = ROTATION ? sweeps_of(b.spin, m->arm, xyz_of(turning), other_arm) : b.spin;
}

INLINE void compare_middles(Dense d, Meeting* m, Bodies b, Quarter motion, Quarter turning, reals other_arm,
                            const global uint* entry) {
  const Quarter middle = fetch(d.records, entry, MIDDLE);
  m->middle_velocity = less(b.middle_velocity, xyz_of(middle));
  m->middle_sweep = b.middle_spin;
  Vectors spin = vectors(motion.w, turning.w, middle.w);
  if (MIDDLE_SPIN_APART) spin = xyz_of(fetch(d.records, entry, MIDDLE + 1));
  if (ROTATION) m->middle_sweep = sweeps_of(b.middle_spin, m->arm, spin, other_arm);
}

// Sums over the partners in one slot. Tells what must be heard of.
INLINE int meet_slot(Dense d, Push* total, Bodies b, int slot, PairLaw law, Alike alike, real duration) {
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
  const int touched = touched_before(d, place);
  Meeting m;
  m.touching = (square < sigma * sigma * d.box->limits.z) & other;
  const bool looks_ahead = HISTORY && d.keeps && !has_row(mark);
  const reals wide = sigma + (looks_ahead ? (real)d.box->near.w : (real)0);
  if (!any_of(looks_ahead ? (square < wide * wide) & other : m.touching) && touched == 0) {
    release_springs(d, place, mark);
    return 0;
  }
  int heard = 0;
  if (looks_ahead) {
    heard = give_row(d, place, &mark);
    if (!any_of(m.touching) && touched == 0) return heard;
  }
  const Quarter motion = fetch(d.records, entry, 1);
  const reals gap = square_gap(x, y, z, d.box->quantum, sum);
  m.touching = m.touching & (gap > 0);
  if (VARIED) m.touching = m.touching & (b.inverse_mass + motion.w > 0);
  const flags was = CORRECTED ? flags_in(touched, b.lane) : m.touching;
  const flags met = m.touching | was;
  const reals nearness = inverse_roots_of(met ? square : (reals)(1)), inverse = inverses_of(square * nearness + sigma);
  m.overlap = met ? gap * inverse : (reals)(0);
  m.normal = scaled(apart, nearness);
  m.root_mass = VARIED ? roots_of(1 / (b.inverse_mass + motion.w)) : (reals)(d.box->body.w);
  m.arm = arm_of(b.radius, m.overlap, law.history);
  const reals radius = VARIED ? to_reals(phases_of(at.w)) * d.box->metre.w : (reals)(d.box->body.x);
  const reals other_arm = arm_of(radius, m.overlap, law.history);
  Quarter turning = motion;
  if (ROTATION) turning = fetch(d.records, entry, 2);
  compare_motion(&m, b, motion, turning, other_arm);
  m.duration = duration;
  if (CORRECTED) {
    const reals mobility = b.inverse_mass + (VARIED ? motion.w : b.inverse_mass);
    const reals other = inverse_inertia_of(d, motion.w, radius);
    m.mobility = mobility;
    if (ROTATION)
      m.mobility = fma(m.arm * m.arm, inverse_inertia_of(d, b.inverse_mass, b.radius), fma(other_arm * other_arm, other, mobility));
    if (ALL_ALIKE) m.mobility = (reals)(alike.mobility);
    foresee(&m, mobility, law, alike, duration);
  }
  if (PREDICTED && HISTORY) compare_middles(d, &m, b, motion, turning, other_arm, entry);
  m.rolls = true;
  if (PREDICTED && HISTORY) stretch_by_middles(&m, d.box->time.y * nearness);
  const Happening h = happening_to(m, was, law, duration);
  if (h.event && !HISTORY) compare_middles(d, &m, b, motion, turning, other_arm, entry);
  Vectors spring = springs_before(d, mark);
  press(d, total, m, was, h, law, &spring, duration);
  keep_springs(d, place, mark, spring);
  if (CORRECTED && (h.event || !(duration > 0))) note_touches(d, place, touched, m.touching);
  const bool too_deep = any_of(m.overlap > d.box->limits.x * (radius < b.radius ? radius : b.radius));
  return heard | (too_deep ? OVERLAPS_TOO_MUCH : 0);
}

INLINE int meet_pairs(Dense d, Push* total, Bodies b, real duration) {
  const int own = d.box->counts.w;
  PairLaw law = d.laws[own * d.box->counts.z + own];
  law.history = HISTORY_VARIANT;
  Alike alike = {1, 1, 0, {0, 0}, {0, 0}};
  if (CORRECTED) alike = alike_of(d, law, duration);
  const int4 head = d.heads[b.group];
  int heard = 0;
  for (int k = head.w; k < head.y; ++k) {
    if (k + 1 < head.y) ask_for(d.records, d.list + (size_t)(head.x + k + 1) * GROUP + b.lane);
    heard |= meet_slot(d, total, b, head.x + k, law, alike, duration);
  }
  return heard;
}
