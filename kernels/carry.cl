// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Memories go from the list that has gone stale to the new one. Both hold partners in order of id; a pair that the
// new one lacks has parted, and one that the old one lacks has not touched.
kernel void carry_springs(const global int* old_starts, const global int* old_partners, const global real4* old_springs,
                          const global int* starts, const global int* partners, global real4* springs) {
  const int i = get_global_id(0);
  const int old_end = old_starts[i + 1];
  int old = old_starts[i];
  for (int k = starts[i]; k < starts[i + 1]; ++k) {
    while (old < old_end && old_partners[old] < partners[k]) ++old;
    const bool known = old < old_end && old_partners[old] == partners[k];
    for (int word = 0; word < MEMORY_WORDS; ++word)
      springs[k * MEMORY_WORDS + word] = known ? old_springs[old * MEMORY_WORDS + word] : (real4)(0);
  }
}
