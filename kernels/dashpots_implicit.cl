// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md, velocity_verlet_implicit. A dashpot takes what it leaves, in half a step by itself, of the
// velocity that springs and fields foretell; friction without memory likewise, as long as it holds. In the stage of the
// springs there is none.
INLINE real left_by(World w, ContactPoint c, real damping, real inverse_mass) {
  if (springs_only(w)) return 0;
  return c.starting ? (real)1 : 1 / (1 + w.constants->time.y * damping * inverse_mass);
}

INLINE real mobility_along(World w, ContactPoint c) {
  return c.inverse_mass + turning_mobility(w, c.self, c.arm, c.other, c.other_arm);
}

INLINE real refined_rate(World w, ContactPoint c, real rate, real stiffness, real damping) {
  return rate * left_by(w, c, damping, c.inverse_mass);
}

INLINE real3 refined_slip(World w, ContactPoint c, real3 slip, real stiffness, real damping) {
  return slip * left_by(w, c, damping, mobility_along(w, c));
}

// Dynamic friction is no dashpot.
INLINE real3 creeping(World w, ContactPoint c, real3 slip, PairLaw law) {
  const real damping = law.viscosity < REAL_MAX ? law.viscosity + law.viscosity_root_mass * c.root_mass : 0;
  return slip * left_by(w, c, damping, mobility_along(w, c));
}

// What dashpots will add decides whether a spring slides, so that the springs' stage knows no limit.
INLINE real holding(World w, real pressing) { return springs_only(w) ? REAL_MAX : pressing; }

typedef struct {
  char nothing;
} Onset;

INLINE bool was_touching(const global real4* memory) { return false; }
INLINE Onset onset_of(World w, ContactPoint* c, PairLaw law) {
  Onset o = {0};
  return o;
}
INLINE void correct_onset(World w, ContactPoint c, PairLaw law, Onset o, Push push, Account* account) {}
INLINE void end_contact(World w, ContactPoint c, PairLaw law, Account* account) {}
INLINE Turnover turnover_of(World w, ContactPoint c, PairLaw law, real3 slip, Account* account) {
  return no_turnover();
}
