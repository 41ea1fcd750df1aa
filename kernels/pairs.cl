// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The list of partners of every moving particle, in order of id: counted, scanned, then filled, so that it never
// overflows. It holds every partner nearer than reach + skin.

// The k-th zone (0 … 2) to look at along an axis, or −1. Fewer than three zones are each looked at once.
INLINE int zone_to_visit(int zone, int k, int zones, int periodic) {
  if (zones < 3) return k < zones ? k : -1;
  const int z = zone + k - 1;
  if (z >= 0 && z < zones) return z;
  return periodic ? (z < 0 ? z + zones : z - zones) : -1;
}

INLINE bool is_partner(World w, Body self, int j) {
  if (j == self.index) return false;
  const Body other = load_body(w, j);
  const Reach reach = sum_of(reach_of(w, self.index, self.position), reach_of(w, j, other.position));
  return within(separation(other.position, self.position, w.box), sum_of(reach, w.box->skin));
}

INLINE int list_zone(World w, Body self, const global int* members, int from, int to, global int* partners) {
  int found = 0;
  for (int m = from; m < to; ++m) {
    if (!is_partner(w, self, members[m])) continue;
    if (partners) partners[found] = members[m];
    ++found;
  }
  return found;
}

INLINE int list_zone_at(World w, Body self, const global int* zone_starts, const global int* members, int x, int y, int z,
                    global int* partners) {
  if (x < 0 || y < 0 || z < 0) return 0;
  const int zone = zone_index((int3)(x, y, z), w.box->zones);
  return list_zone(w, self, members, zone_starts[zone], zone_starts[zone + 1], partners);
}

// Counts the partners of `self`, and writes them where `partners` is not null.
INLINE int list_partners(World w, Body self, const global int* zone_starts, const global int* members,
                         global int* partners) {
  const int4 zones = w.box->zones;
  const int3 home = zone_of(self.position, w.box);
  int found = 0;
  for (int kz = 0; kz < 3; ++kz)
    for (int ky = 0; ky < 3; ++ky)
      for (int kx = 0; kx < 3; ++kx) {
        const int x = zone_to_visit(home.x, kx, zones.x, PERIODIC_X);
        const int y = zone_to_visit(home.y, ky, zones.y, PERIODIC_Y);
        const int z = zone_to_visit(home.z, kz, zones.z, PERIODIC_Z);
        found += list_zone_at(w, self, zone_starts, members, x, y, z, partners ? partners + found : 0);
      }
  return found;
}

kernel void pair_count(WORLD_PARAMETERS, const global int* zone_starts, const global int* members,
                       global int* pair_counts) {
  const World w = WORLD;
  const int i = get_global_id(0);
  const Body self = load_body(w, i);
  pair_counts[i] = self.inverse_mass > 0 ? list_partners(w, self, zone_starts, members, 0) : 0;
}

kernel void pair_fill(WORLD_PARAMETERS, const global int* zone_starts, const global int* members,
                      const global int* pair_starts, global int* partners) {
  const World w = WORLD;
  const int i = get_global_id(0);
  const Body self = load_body(w, i);
  if (!(self.inverse_mass > 0)) return;
  global int* own = partners + pair_starts[i];
  sort_few(own, list_partners(w, self, zone_starts, members, own));
}
