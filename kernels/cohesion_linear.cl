// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/cohesion.md: k_c δ_e while the effect surfaces overlap; attractive (E7), also during body contact.
INLINE bool reaches_farther() { return true; }
INLINE Reach reach_of(World w, int i, Position p) { return w.reaches[i]; }
INLINE real attraction(real reach_overlap, PairLaw law) { return law.cohesion * reach_overlap; }

INLINE real cohesive_energy(real reach_overlap, PairLaw law) {
  return -(real)0.5 * law.cohesion * reach_overlap * reach_overlap;
}
