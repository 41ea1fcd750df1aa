// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What happens to contacts in a step, and their forces, once it is known how springs slide.

// Whether contacts begin, end or let go, and those that last and whose normal force has changed its sign.
typedef struct {
  flags turns;
  bool event, turned;
} Happening;

INLINE Happening happening_to(Meeting m, flags was, PairLaw law, real duration) {
  Happening h = {m.touching & ~m.touching, false, false};
  if (!CORRECTED || !(duration > 0)) return h;
  flags some = m.touching ^ was;
  if (law.lowest == 0) some = some | (m.touching & was & pulling(m, law));
  if (HISTORY) h.turns = turning_over(m, was, law, duration);
  if (!any_of(some | h.turns)) return h;
  h.event = any_of(some);
  h.turned = HISTORY && any_of(h.turns);
  return h;
}

INLINE Vectors holding_force(Push* total, Vectors* spring, Vectors slip, Meeting m, reals pressing, PairLaw law,
                             real step) {
  const reals damping = spring_dashpot_of(law, m.root_mass);
  const Vectors stretching = PREDICTED ? chosen(m.touching, m.stretching, vectors(0, 0, 0)) : slip;
  const reals limit = law.sliding * magnitudes(pressing);
  const Vectors held = carried_springs(*spring, m, law.history);
  *spring = plus_scaled(held, stretching, m.duration);
  if (CORRECTED) return gripping_along(total, spring, held, slip, m, limit, law, step);
  return gripping_force(spring, scaled(slip, damping), limit, law);
}

INLINE Grasp push(Push* total, Meeting m, PairLaw law, Vectors* spring, real step) {
  const reals separating = inner(m.velocity, m.normal);
  Grasp g = {pressing_force(m, CORRECTED ? separating * m.foreseen : separating, law), vectors(0, 0, 0)};
  Vectors force = scaled(m.normal, g.pressing);
  if (FRICTION || HISTORY) {
    const Vectors slip =
        chosen(m.touching, slip_of(m.velocity, separating, m.sweep, m.normal), vectors(0, 0, 0));
    if (FRICTION) g.rubbing = viscous_friction(slip, g.pressing, law, m.root_mass);
    if (HISTORY && (law.history & REMEMBERS))
      g.rubbing = less(g.rubbing, holding_force(total, spring, slip, m, g.pressing, law, step));
    if (ROTATION) add(&total->torque, scaled(outer(m.normal, g.rubbing), -m.arm), total->torque_unit);
    force = plus_scaled(force, g.rubbing, (reals)(1));
  }
  add(&total->force, force, total->force_unit);
  return g;
}
