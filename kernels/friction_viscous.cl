// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/friction.md: min(c |u_t|, μ |F_n|) against the slip. The variants differ in c alone, which the host
// derives; the purely dynamic one has a c beyond every limit.
INLINE real3 friction_force(real3 slip, real pressing, PairLaw law, real root_mass) {
  const real speed = square_root(slip.x * slip.x + slip.y * slip.y + slip.z * slip.z);
  if (!(speed > 0)) return (real3)(0);
  const real sticking = (law.viscosity + law.viscosity_root_mass * root_mass) * speed;
  const real force = lesser_of(sticking, law.friction * magnitude(pressing));
  return slip * (-force / speed);
}
