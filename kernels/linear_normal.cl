// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/linear.md: k δ − η u_n, clamped from below where the law never pulls. With Hertz, docs/laws/hertz.md,
// k grows by a factor, the rise, and η by its root.
INLINE real dashpot(PairLaw law, real root_mass) { return law.damping + law.damping_root_mass * root_mass; }

INLINE real normal_force(real overlap, real separating_speed, PairLaw law, real root_mass, Rise rise) {
  const real force = law.stiffness * rise.factor * overlap - dashpot(law, root_mass) * rise.root * separating_speed;
  return greater_of(force, law.lowest);
}

INLINE real elastic_energy(real overlap, PairLaw law, Rise rise) {
  return rise.energy * law.stiffness * rise.factor * overlap * overlap;
}
