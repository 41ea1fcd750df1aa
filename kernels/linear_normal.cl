// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/linear.md: k δ − η u_n, clamped from below where the law never pulls.
INLINE real dashpot(PairLaw law, real root_mass) { return law.damping + law.damping_root_mass * root_mass; }

INLINE real normal_force(real overlap, real separating_speed, PairLaw law, real root_mass) {
  const real force = law.stiffness * overlap - dashpot(law, root_mass) * separating_speed;
  return greater_of(force, law.lowest);
}

INLINE real elastic_energy(real overlap, PairLaw law) { return (real)0.5 * law.stiffness * overlap * overlap; }
