// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What acts on one body of each of many contacts; docs/laws/linear.md, friction.md, history.md.
// What a dashpot is told less what was true: so much of the predicted velocity, so much of that at the last boundary.
typedef struct {
  real now, before;
} Untrue;

// Between particles that are all alike, the same for all contacts.
typedef struct {
  real rate, slip;  // what the contact itself leaves of them
  real mobility;    // along the tangent plane
  Untrue untrue_rate, untrue_slip;
} Alike;
#define ARMS_VARY (ROTATION && (HISTORY_VARIANT & ARM_SHORTENED))
#define ALL_ALIKE (!(VARIED || ARMS_VARY))

typedef struct {
  flags touching;
  Vectors normal;    // to the body
  Vectors velocity;  // of the body's centre relative to the other's
  Vectors sweep;     // arms times angular velocities, of both
  Vectors middle_velocity, middle_sweep;  // likewise, in the middle of the step that has led here
  Vectors stretching;                     // the slip that stretches a spring
  bool rolls;                             // two spheres, round each other
  Vectors around;                         // in the middle of the step; that times `turn` is half of what it has
  reals turn, closer;                     // changed the normal by, which brings them closer there
  flags lasts;                            // through the whole step
  reals duration;                         // for which it does
  reals foreseen, foreseen_slip;          // what the contact itself will leave of the rate and the slip
  Alike alike;                            // of particles
  reals overlap;
  reals root_mass;   // of the effective mass
  reals arm;
  reals mobility;    // inverse effective mass along the tangent plane
} Meeting;

// What a contact does.
typedef struct {
  reals pressing;
  Vectors rubbing;
} Grasp;

typedef struct {
  Sum force;
  Sum torque;
  Sum impulse, moment, twist;  // of contacts that begin or end; over the step, its square and the step
  bool corrected;
  real force_unit;
  real torque_unit;
} Push;

INLINE reals dashpot_of(PairLaw law, reals root_mass) { return law.damping + law.damping_root_mass * root_mass; }
INLINE reals spring_dashpot_of(PairLaw law, reals root_mass) {
  return law.spring_damping + law.spring_damping_root_mass * root_mass;
}

INLINE Vectors slip_of(Vectors velocity, reals separating, Vectors sweep, Vectors normal) {
  const Vectors slip = plus_scaled(velocity, normal, -separating);
  return ROTATION ? less(slip, outer(sweep, normal)) : slip;
}

INLINE reals pressing_force(Meeting m, reals separating, PairLaw law) {
  const reals damping = dashpot_of(law, m.root_mass);
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
  return scaled(flat, root_ratios_of(inner(spring, spring), square));
}

// Against the slip; leaves in `spring`, which is a trial, what the Coulomb limit leaves of it.
INLINE Vectors gripping_force(Vectors* spring, Vectors damped, reals limit, PairLaw law) {
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  const real stiffness = law.spring, compliance = 1 / law.spring;
  const Vectors trial = *spring;
  Vectors force = plus_scaled(damped, trial, (reals)(stiffness));
  const reals held = alone ? stiffness * stiffness * inner(trial, trial) : inner(force, force);
  const flags slides = held > limit * limit;
  if (any_of(slides)) {
    const reals share = limit * inverse_roots_of(slides ? held : 1);
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

// Spheres that roll round each other take a spring with them. One that has not lasted lies in the plane of now.
INLINE Vectors carried_springs(Vectors spring, Meeting m, int variant) {
  if (!CORRECTED || !m.rolls) return turned_springs(spring, m.normal, variant);
  const reals across = inner(spring, m.normal);
  return plus_scaled(plus_scaled(spring, m.normal, -across), m.around, across * m.turn);
}

INLINE reals arm_of(reals radius, reals overlap, int variant) {
  return variant & ARM_SHORTENED ? fma((reals)(-0.5f), overlap, radius) : radius;
}
