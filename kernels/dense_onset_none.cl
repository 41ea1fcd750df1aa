// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Contacts begin and end with a boundary: nothing of dense_onset.cl is ever asked.
typedef struct {
  flags begins;
} Onset;

INLINE reals refinement(real step, reals mobility, real stiffness, reals damping) { return 1; }
INLINE flags pulling(Meeting m, PairLaw law) { return m.touching; }
INLINE flags turning_over(Meeting m, flags was, PairLaw law, real step) { return m.touching; }
INLINE Vectors turn_over(Meeting* m, flags turns, PairLaw law, Vectors* spring, real step) { return m->normal; }
INLINE void end_turnover(Push* total, Meeting m, flags turns, Vectors rub, Grasp g, PairLaw law, real step) {}
INLINE Vectors gripping_along(Push* total, Vectors* spring, Vectors held, Vectors slip, Meeting m, reals limit,
                              PairLaw law, real step) {
  return held;
}
INLINE Onset onset_of(Meeting* m, flags was, PairLaw law, Vectors* spring, real step, int terms) {
  const Onset none = {m->touching};
  return none;
}
INLINE void correct(Push* total, Meeting m, Onset o, Grasp g, real step) {}
