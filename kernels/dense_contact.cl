// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What acts on one body of each of many contacts; docs/laws/linear.md, friction.md, history.md.
typedef struct {
  flags touching;
  Vectors normal;    // to the body
  Vectors velocity;  // of the body's centre relative to the other's
  Vectors sweep;     // arms times angular velocities, of both
  reals overlap;
  reals root_mass;   // of the effective mass
  reals arm;
} Meeting;

typedef struct {
  Sum force;
  Sum torque;
  real force_unit;
  real torque_unit;
} Push;

INLINE reals pressing_force(Meeting m, reals separating, PairLaw law) {
  const reals damping = law.damping + law.damping_root_mass * m.root_mass;
  const reals force = fma((reals)(law.stiffness), m.overlap, -(damping * separating));
  const reals clamped = force > law.lowest ? force : law.lowest;
  return m.touching ? clamped : 0;
}

INLINE Vectors viscous_friction(Vectors slip, reals pressing, PairLaw law, reals root_mass) {
  const reals speed = roots_of(inner(slip, slip));
  const reals sticking = (law.viscosity + law.viscosity_root_mass * root_mass) * speed;
  const reals limit = law.friction * magnitudes(pressing);
  const reals force = sticking < limit ? sticking : limit;
  return scaled(slip, speed > 0 ? -force / speed : 0);
}

INLINE Vectors turned_springs(Vectors spring, Vectors normal, int variant) {
  const Vectors flat = plus_scaled(spring, normal, -inner(spring, normal));
  if (variant & TURN_PROJECTS) return flat;
  const reals square = inner(flat, flat);
  return scaled(flat, square > 0 ? roots_of(inner(spring, spring) / square) : 1);
}

// Against the slip; leaves in `spring` what the Coulomb limit leaves of it.
INLINE Vectors holding_force(Vectors* spring, Vectors slip, Meeting m, reals pressing, PairLaw law, real duration) {
  const reals damping = law.spring_damping + law.spring_damping_root_mass * m.root_mass;
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  const real stiffness = law.spring, compliance = 1 / law.spring;
  const Vectors trial = plus_scaled(turned_springs(*spring, m.normal, law.history), slip, (reals)(duration));
  const Vectors damped = scaled(slip, damping);
  Vectors force = plus_scaled(damped, trial, (reals)(stiffness));
  const reals limit = law.sliding * magnitudes(pressing);
  const reals held = alone ? stiffness * stiffness * inner(trial, trial) : inner(force, force);
  const flags slides = held > limit * limit;
  *spring = trial;
  if (any_of(slides)) {
    const reals share = limit / roots_of(slides ? held : 1);
    if (alone) {
      *spring = chosen(slides, scaled(trial, share), trial);
      force = chosen(slides, scaled(*spring, (reals)(stiffness)), force);
    } else {
      force = chosen(slides, scaled(force, share), force);
      *spring = chosen(slides, scaled(less(force, damped), (reals)(compliance)), trial);
    }
  }
  return force;
}

INLINE void push(Push* total, Meeting m, PairLaw law, Vectors* spring, real duration) {
  const reals separating = inner(m.velocity, m.normal);
  const reals pressing = pressing_force(m, separating, law);
  Vectors force = scaled(m.normal, pressing);
  if (FRICTION || HISTORY) {
    Vectors slip = plus_scaled(m.velocity, m.normal, -separating);
    if (ROTATION) slip = less(slip, outer(m.sweep, m.normal));
    slip = chosen(m.touching, slip, vectors(0, 0, 0));
    Vectors rubbing = vectors(0, 0, 0);
    if (FRICTION) rubbing = viscous_friction(slip, pressing, law, m.root_mass);
    if (HISTORY && (law.history & REMEMBERS))
      rubbing = less(rubbing, holding_force(spring, slip, m, pressing, law, duration));
    if (ROTATION) add(&total->torque, scaled(outer(m.normal, rubbing), -m.arm), total->torque_unit);
    force = plus_scaled(force, rubbing, (reals)(1));
  }
  add(&total->force, force, total->force_unit);
}

INLINE reals arm_of(reals radius, reals overlap, int variant) {
  return variant & ARM_SHORTENED ? fma((reals)(-0.5f), overlap, radius) : radius;
}
