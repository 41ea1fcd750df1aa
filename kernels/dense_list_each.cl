// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The list with one work-item a particle, which keeps nothing but counts to itself: partners are counted, windows put
// in order by a work-group each, and partners looked for once more, to be written where they belong.
typedef struct {
  const KNOWN DenseBox* box;
  const global uint* coarse;  // dense_coarse
  const global int* zone_starts;
  int padded;
  int self;
  uint x, y, z;
  float radius;
} Seeker;

// Of a kernel's own arguments.
#define SEEKER_OF(self)                                                                                             \
  {box, coarse, zone_starts, padded, self, coarse[self], coarse[padded + self], coarse[2 * padded + self],          \
   as_float(coarse[3 * padded + self])}

// Where partners go: nowhere while they are counted, else into the lane of the particle, named by their places.
typedef struct {
  bool writes;
  int4 head;
  int group_lane;
  int old;
  int near_count;
  Former former;
  Latter latter;
  const global int* places;
} Sink;

typedef struct {
  int near, far;
} Counts;

INLINE void take(const Sink* sink, Counts* counts, int partner, bool near) {
  const int place = near ? counts->near : sink->near_count + counts->far;
  if (near)
    ++counts->near;
  else
    ++counts->far;
  if (!sink->writes) return;
  const int slot = sink->head.x + sink->head.w + place;
  sink->latter.list[(size_t)slot * GROUP + sink->group_lane] = (uint)sink->places[partner] * UNITS_A_RECORD;
  if (HISTORY && near)
    put_spring(sink->latter.springs, sink->latter.marks + mark_at(slot, sink->group_lane), sink->group_lane,
               spring_between(sink->former, sink->old, sink->former.members[partner]));
}

INLINE float metres_apart(uint a, uint b, float metre) { return (float)(int)(a - b) * metre; }

INLINE void take_among(Seeker s, int from, int to, const Sink* sink, Counts* counts) {
  const global uint *x = s.coarse, *y = x + s.padded, *z = y + s.padded;
  const global float* radii = (const global float*)(z + s.padded);
  const float4 metre = s.box->coarse_metre, limits = s.box->near;
  for (int j = from; j < to; ++j) {
    const float dx = metres_apart(s.x, x[j], metre.x), dy = metres_apart(s.y, y[j], metre.y),
                dz = metres_apart(s.z, z[j], metre.z);
    const float square = fma(dx, dx, fma(dy, dy, dz * dz));
    const float reach = VARIED ? s.radius + (radii[j] + metre.w) : limits.y;
    const float near_reach = VARIED ? reach - (metre.w - limits.x) : limits.z;
    if (square < reach * reach && j != s.self) take(sink, counts, j, square < near_reach * near_reach);
  }
}

// The zones around it in a row of them, and that beyond the row's end where it is periodic.
INLINE void take_in_row(Seeker s, int row, int across, const Sink* sink, Counts* counts) {
  const int zones = s.box->zones.x, low = max(across - 1, 0), high = min(across + 1, zones - 1);
  const global int* starts = s.zone_starts + row * zones;
  take_among(s, starts[low], starts[high + 1], sink, counts);
  if (!s.box->periodic.x) return;
  if (across == 0 && high < zones - 1) take_among(s, starts[zones - 1], starts[zones], sink, counts);
  if (across == zones - 1 && low > 0) take_among(s, starts[0], starts[1], sink, counts);
}

INLINE void take_all(Seeker s, int zone, const Sink* sink, Counts* counts) {
  const int4 zones = s.box->zones, periodic = s.box->periodic;
  const int2 at = place_of_row(s.box, zone / zones.x);
  for (int k = 0; k < 9; ++k) {
    const int y = row_to_visit(at.x, k % 3, zones.y, periodic.y), z = row_to_visit(at.y, k / 3, zones.z, periodic.z);
    if (y >= 0 && z >= 0) take_in_row(s, row_at(s.box, y, z), zone % zones.x, sink, counts);
  }
}

// near_counts: of particles in order of zones. A work-group is a window; order, places: dense_list.
kernel void dense_count(const KNOWN DenseBox* box, const global uint* coarse, const global int* zones_of,
                        const global int* zone_starts, global int* near_counts, global int* order, global int* places,
                        const int padded) {
  local int buckets[WINDOW];
  const int self = get_global_id(0), item = get_local_id(0), first = self - item;
  Sink nowhere;  // counted alone
  nowhere.writes = false;
  nowhere.near_count = 0;
  int bucket = BUCKETS;
  if (self < box->counts.x) {
    const Seeker seeker = SEEKER_OF(self);
    Counts counts = {0, 0};
    take_all(seeker, zones_of[self], &nowhere, &counts);
    near_counts[self] = counts.near | counts.far << 16;
    bucket = bucket_of(counts.near, counts.far);
  }
  buckets[item] = bucket;
  barrier(CLK_LOCAL_MEM_FENCE);
  int rank = 0;
  for (int k = 0; k < WINDOW; ++k) rank += buckets[k] < bucket || (buckets[k] == bucket && k < item);
  order[first + rank] = self;
  places[self] = first + rank;
}

// What the groups of a window have to hold: atomics on the window's own memory, in which no order shows.
typedef struct {
  int planes[WINDOW / GROUP], near[WINDOW / GROUP], slots[WINDOW / GROUP], rows[WINDOW / GROUP];
  int4 heads[WINDOW / GROUP];
} Window;

INLINE void make_head(local Window* w, int g, global int* totals, global int4* heads, int group) {
  const int walls = HISTORY ? popcount((uint)(w->planes[g] & ~(1 << FACE_BIT))) : 0;
  const int slots = walls + w->slots[g], rows = HISTORY ? (walls + w->near[g]) * SPANS : 0;
  w->near[g] += walls;
  w->rows[g] = rows > 0 ? atomic_add(totals + ROWS_WANTED, rows) : 0;
  w->heads[g] = (int4)(slots > 0 ? atomic_add(totals + SLOTS_WANTED, slots) : 0, slots, w->planes[g], walls);
  heads[group] = w->heads[g];
}

// What stands in a lane before and behind its partners: itself.
INLINE void fill_lane(Latter l, int4 head, int lane, int place, Counts counts, int rows, int first_row) {
  for (int k = 0; k < head.y; ++k) {
    const bool partner = k >= head.w && k < head.w + counts.near + counts.far;
    if (!partner) l.list[(size_t)(head.x + k) * GROUP + lane] = (uint)place * UNITS_A_RECORD;
    if (HISTORY) l.marks[mark_at(head.x + k, lane)] = k < rows ? mark_of_row(first_row + k * SPANS + lane) : 0;
  }
}

INLINE void carry_walls(const Sink* sink, int lane) {
  int slot = sink->head.x;
  for (int walls = sink->head.z & ~(1 << FACE_BIT); walls != 0; walls &= walls - 1, ++slot)
    put_spring(sink->latter.springs, sink->latter.marks + mark_at(slot, lane), lane,
               former_spring(sink->former, sink->old, WALL_PARTNER | (uint)lowest_bit((uint)walls), 1));
}

// Of the particle that will stand at a place, a work-group a window. As dense_list in dense_list.cl, but for names.
kernel void dense_list(const KNOWN DenseBox* box, const global DensePlane* planes, const global real4* records,
                       const global int* cells, const global uint* coarse, const global int* zones_of,
                       const global int* zone_starts, const global int* members, const global int* starts,
                       const global uint* partners, const global real* packed, global int4* heads, global uint* list,
                       global real* springs, global int* marks, const global int* order, const global int* places,
                       const global int* near_counts, global int* totals, const int padded, const int room,
                       const int row_room) {
  local Window window;
  const int place = get_global_id(0), item = get_local_id(0), g = item / GROUP, lane = item % GROUP;
  const int self = order[place], old = members[self];
  const bool is_one = self < box->counts.x;
  const int both = is_one ? near_counts[self] : 0;
  const Counts counts = {both & 0xffff, both >> 16};
  if (lane == 0) window.planes[g] = window.near[g] = window.slots[g] = 0;
  barrier(CLK_LOCAL_MEM_FENCE);
  if (is_one) {
    atomic_or(window.planes + g, walls_near(box, planes, phase4_at(records, old), cells_in(cells[old])));
    atomic_max(window.near + g, counts.near);
    atomic_max(window.slots + g, counts.near + counts.far);
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  if (lane == 0) make_head(&window, g, totals, heads, place / GROUP);
  barrier(CLK_LOCAL_MEM_FENCE);
  const int4 head = window.heads[g];
  const int rows = HISTORY ? window.near[g] : 0;
  if (head.x + head.y > room || window.rows[g] + rows * SPANS > row_room) return;
  const Latter latter = {heads, list, springs, marks};
  const Former former = {starts, partners, packed, members};
  const Sink sink = {true, head, lane, old, counts.near, former, latter, places};
  fill_lane(latter, head, lane, place, counts, rows, window.rows[g]);
  if (!is_one) return;
  if (HISTORY) carry_walls(&sink, lane);
  const Seeker seeker = SEEKER_OF(self);
  Counts taken = {0, 0};
  take_all(seeker, zones_of[self], &sink, &taken);
}
