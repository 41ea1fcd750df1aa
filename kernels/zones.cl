// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Spatial zoning: count the particles of every zone, scan the counts into starts, fill, and put each zone
// in order of id, so that nothing depends on which thread came first.
INLINE int zone_index(int3 zone, int4 zones) { return (zone.z * zones.y + zone.y) * zones.x + zone.x; }

kernel void zone_count(WORLD_PARAMETERS, global int* zone_counts, global int* zone_of_particle,
                       global Position* built_at) {
  const World w = WORLD;
  const int i = get_global_id(0);
  built_at[i] = w.positions[i];
  if (i >= w.constants->counts.x) return;
  const int zone = zone_index(zone_of(w.positions[i], w.box), w.box->zones);
  zone_of_particle[i] = zone;
  atomic_inc(&zone_counts[zone]);
}

// Counts the zones down again, to zero, ready for the next time.
kernel void zone_fill(const global int* zone_of_particle, const global int* zone_starts, global int* zone_counts,
                      global int* members, const int particles) {
  const int i = get_global_id(0);
  if (i >= particles) return;
  const int zone = zone_of_particle[i];
  members[zone_starts[zone] + atomic_dec(&zone_counts[zone]) - 1] = i;
}

kernel void zone_order(const global int* zone_starts, global int* members, const int zones) {
  const int zone = get_global_id(0);
  if (zone >= zones) return;
  sort_few(members + zone_starts[zone], zone_starts[zone + 1] - zone_starts[zone]);
}
