// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Planes and the faces of the domain, looked at only by groups that were near one when the list was built.
typedef struct {
  lengths x, y, z;
} Places;

// From the cell it is in now: rounding must not tell where it was when the list was made.
INLINE lengths place_along(phases now, phases then, indices cells, int shift, double lower, double cell, double unit) {
  return lower + (exact_indices((cells >> shift) & 1023) + cells_entered(now, then)) * cell + exact_phases(now) * unit;
}

INLINE Places places_of(Dense d, Bodies b) {
  const global phase* then = d.built_at + (size_t)b.group * (3 * GROUP) + b.lane;
  const indices cells = load_indices(d.cells + b.first);
  const double4 lower = d.box->lower, cell = d.box->cell, unit = d.box->quantum;
  Places p;
  p.x = place_along(b.x, load_phases(then), cells, 0, lower.x, cell.x, unit.x);
  p.y = place_along(b.y, load_phases(then + GROUP), cells, 10, lower.y, cell.y, unit.y);
  p.z = place_along(b.z, load_phases(then + 2 * GROUP), cells, 20, lower.z, cell.z, unit.z);
  return p;
}

INLINE int meet_plane(Dense d, Push* total, Bodies b, Places p, const global DensePlane* plane, int slot,
                      real duration) {
  const double4 n = plane->normal;
  const lengths radius = VARIED ? length_in(b.radius_phase, d.box->quantum.w) : (lengths)(d.box->alike.y);
  Meeting m;
  m.overlap = rounded(radius - (p.x * n.x + p.y * n.y + p.z * n.z - n.w));
  m.touching = (m.overlap > 0) & b.moves;
  const size_t place = mark_at(slot, b.lane);
  const int mark = HISTORY ? d.marks[place] : 0, touched = touched_before(d, place);
  if (!any_of(m.touching) && touched == 0) {
    release_springs(d, place, mark);
    return 0;
  }
  const PairLaw law = d.laws[d.box->counts.w * d.box->counts.z + plane->wall.x];
  const flags was = CORRECTED ? flags_in(touched, b.lane) : m.touching, met = m.touching | was;
  m.overlap = met ? m.overlap : (reals)(0);
  m.normal = vectors((real)n.x, (real)n.y, (real)n.z);
  m.velocity = b.velocity;
  m.root_mass = roots_of(1 / (met ? b.inverse_mass : (reals)(1)));
  m.arm = arm_of(b.radius, m.overlap, law.history);
  m.sweep = scaled(b.spin, m.arm);
  m.middle_velocity = b.middle_velocity;
  m.middle_sweep = scaled(b.middle_spin, m.arm);
  m.duration = duration;
  m.rolls = false;
  if (PREDICTED && HISTORY) stretch_by_middles(&m, (reals)(0));
  if (CORRECTED) {
    m.mobility = b.inverse_mass;
    if (ROTATION) m.mobility = fma(m.arm * m.arm, inverse_inertia_of(d, b.inverse_mass, b.radius), b.inverse_mass);
    m.foreseen = refinement(duration, b.inverse_mass, law.stiffness, dashpot_of(law, m.root_mass));
    if (HISTORY) m.foreseen_slip = refinement(duration, m.mobility, law.spring, spring_dashpot_of(law, m.root_mass));
  }
  const Happening h = happening_to(m, was, law, duration);
  Vectors spring = springs_before(d, mark);
  press(d, total, m, was, h, law, &spring, duration);
  keep_springs(d, place, mark, spring);
  if (CORRECTED && (h.event || !(duration > 0))) note_touches(d, place, touched, m.touching);
  return any_of(m.overlap > d.box->limits.x * b.radius) ? OVERLAPS_TOO_MUCH : 0;
}

INLINE int meet_walls(Dense d, Push* total, Bodies b, real duration) {
  const int4 head = d.heads[b.group];
  int heard = 0;
  if ((head.z & ~(1 << FACE_BIT)) == 0) return 0;
  const Places p = places_of(d, b);
  int slot = head.x;
  for (int k = 0; k < d.box->counts.y; ++k)
    if (head.z >> k & 1) heard |= meet_plane(d, total, b, p, d.planes + k, slot++, duration);
  return heard;
}

// Whether one has left the domain. No face was near a group without the bit, so there only one that has moved too far
// for the list can have.
INLINE bool escapes(Dense d, Bodies b, bool stale) {
  if (!stale && (d.heads[b.group].z >> FACE_BIT & 1) == 0) return false;
  const Places p = places_of(d, b);
  const double4 low = d.box->domain_lower, high = d.box->domain_upper;
  return any_of(b.moves & flags_of((p.x < low.x) | (p.x > high.x) | (p.y < low.y) | (p.y > high.y) | (p.z < low.z) |
                                   (p.z > high.z)));
}
