// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What acts on one body of each of many contacts; docs/laws/linear.md, friction.md, history.md.
typedef struct {
  flags touching;
  Vectors normal;    // to the body
  Vectors velocity;  // of the body's centre relative to the other's
  Vectors sweep;     // arms times angular velocities, of both
  Vectors middle_velocity, middle_sweep;  // likewise, in the middle of the step that has led here
  Vectors stretching;                     // the slip that stretches a spring
  bool rolls;                             // two spheres, round each other
  Vectors round;                          // half of what that has changed the normal by in the step
  flags lasts;                            // through the whole step
  reals duration;                         // for which it does
  reals foreseen, foreseen_slip;          // what the contact itself will leave of the rate and the slip
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
  return plus_scaled(plus_scaled(spring, m.normal, -across), m.round, across);
}

// Of a force that has turned since the step's start and is `length` now: a cut in either half of the step counted twice,
// less the one at its end.
INLINE Vectors cut_along(Vectors before, Vectors trial, reals length, reals limit) {
  const Vectors straight = scaled(trial, 1 / length);
  const Vectors middle = scaled(plus_scaled(before, trial, (reals)(1)), (reals)(0.5f));
  const reals halfway = (real)0.5f * (roots_of(inner(before, before)) + limit), reached = roots_of(inner(middle, middle));
  const Vectors second = plus_scaled(trial, middle, reached > halfway ? (halfway - reached) / reached : 0);
  const reals square = inner(second, second);
  const Vectors way = less(scaled(second, 2 / roots_of(square > 0 ? square : 1)), straight);
  return scaled(way, limit / roots_of(inner(way, way)));
}

// As gripping_force(); `held` is what the spring was before the slip of the step's middle stretched it.
INLINE Vectors gripping_along(Vectors* spring, Vectors held, Vectors slip, Meeting m, reals limit, PairLaw law) {
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  const reals damping = spring_dashpot_of(law, m.root_mass) * m.foreseen_slip;
  const Vectors trial = *spring, damped = scaled(slip, damping), pull = scaled(trial, (reals)(law.spring));
  const Vectors sum = plus_scaled(damped, trial, (reals)(law.spring)), limited = alone ? pull : sum;
  const reals square = inner(limited, limited);
  const flags slides = square > limit * limit;
  if (!any_of(slides)) return sum;
  const reals length = roots_of(slides ? square : 1);
  const Vectors earlier = plus_scaled(m.stretching, slip, (reals)(-0.5f));
  const Vectors before = plus_scaled(scaled(held, (reals)(law.spring)), earlier, alone ? (reals)(0) : 2 * damping);
  const Vectors cut = chosen(m.lasts, cut_along(before, limited, length, limit), scaled(limited, limit / length));
  *spring = chosen(slides, scaled(alone ? cut : less(cut, damped), (reals)(1 / law.spring)), trial);
  return chosen(slides, cut, sum);
}

INLINE Vectors holding_force(Vectors* spring, Vectors slip, Meeting m, reals pressing, PairLaw law) {
  const reals damping = spring_dashpot_of(law, m.root_mass);
  const Vectors stretching = PREDICTED ? chosen(m.touching, m.stretching, vectors(0, 0, 0)) : slip;
  const reals limit = law.sliding * magnitudes(pressing);
  const Vectors held = carried_springs(*spring, m, law.history);
  *spring = plus_scaled(held, stretching, m.duration);
  if (CORRECTED) return gripping_along(spring, held, slip, m, limit, law);
  return gripping_force(spring, scaled(slip, damping), limit, law);
}

INLINE Grasp push(Push* total, Meeting m, PairLaw law, Vectors* spring) {
  const reals separating = inner(m.velocity, m.normal);
  Grasp g = {pressing_force(m, CORRECTED ? separating * m.foreseen : separating, law), vectors(0, 0, 0)};
  Vectors force = scaled(m.normal, g.pressing);
  if (FRICTION || HISTORY) {
    const Vectors slip =
        chosen(m.touching, slip_of(m.velocity, separating, m.sweep, m.normal), vectors(0, 0, 0));
    if (FRICTION) g.rubbing = viscous_friction(slip, g.pressing, law, m.root_mass);
    if (HISTORY && (law.history & REMEMBERS))
      g.rubbing = less(g.rubbing, holding_force(spring, slip, m, g.pressing, law));
    if (ROTATION) add(&total->torque, scaled(outer(m.normal, g.rubbing), -m.arm), total->torque_unit);
    force = plus_scaled(force, g.rubbing, (reals)(1));
  }
  add(&total->force, force, total->force_unit);
  return g;
}

INLINE reals arm_of(reals radius, reals overlap, int variant) {
  return variant & ARM_SHORTENED ? fma((reals)(-0.5f), overlap, radius) : radius;
}
