// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md: a contact that begins or ends within a step acts for the time that it lasted. Each body of
// a pair works its own half out of the same numbers, and nothing depends on which of them it is but by a sign.
typedef struct {
  flags begins, ends;     // ends: or lets go, where contacts never pull
  reals time;             // in contact
  reals impulse, moment;  // of the normal force
  reals before;           // normal force at the last boundary
  Vectors rub, rubbed;    // impulse of friction; friction at the last boundary
} Onset;

// What a contact leaves of a predicted rate: 1 + c over 1 + c + κ.
INLINE reals refinement(real step, reals mobility, real stiffness, reals damping) {
  const reals braked = fma((real)0.5f * step * damping, mobility, (reals)(1));
  return braked / fma((reals)((real)0.5f * step * step * stiffness), mobility, braked);
}

INLINE flags pulling(Meeting m, PairLaw law) {
  return !(full_force(m.overlap, -inner(m.velocity, m.normal), law, m.root_mass) > 0);
}

// Contacts that last and whose normal force has changed its sign since the last boundary.
INLINE flags turning_over(Meeting m, flags was, PairLaw law, real step) {
  const flags pulled = !(pressed_before(m, law, step).force > 0);
  return m.touching & was & (pulling(m, law) ^ pulled);
}

// Until there is no overlap left, or where contacts never pull no force, which swings as the overlap does.
INLINE reals time_left(Before b, real step, PairLaw law, Swing swing) {
  const reals apart = parting_time(b.overlap, b.rate, step, swing);
  if (law.lowest < 0) return apart;
  const reals change = law.stiffness * b.rate - swing.damping * b.force;
  const reals slack = parting_time(b.force, change, step, swing);
  return apart < slack ? apart : slack;
}

// Its impulse over `time`, were it never to change its sign, by Simpson's rule.
INLINE reals pressing_impulse(Before b, reals time, Flow end, PairLaw law, Swing swing, reals root_mass) {
  const reals half_time = (real)0.5f * time;
  const Flow middle = flow_of(b.overlap, b.rate, half_time, swing);
  const reals halfway = b.overlap + half_time * b.rate + middle.way, last = b.overlap + time * b.rate + end.way;
  const reals second = full_force(halfway, b.rate + middle.gain, law, root_mass);
  const reals third = full_force(last, b.rate + end.gain, law, root_mass);
  return (magnitudes(b.force) + 4 * magnitudes(second) + magnitudes(third)) * (time * (real)(1.0 / 6.0));
}

// Friction of a spring, a way on it and what presses; or its impulse, of their sums over time.
INLINE Vectors rubbing_of(Vectors spring, Vectors slip, reals pressing, Meeting m, PairLaw law) {
  Vectors rubbing = vectors(0, 0, 0);
  if (FRICTION) rubbing = viscous_friction(slip, pressing, law, m.root_mass);
  if (HISTORY && (law.history & REMEMBERS)) {
    const Vectors damped = scaled(slip, spring_dashpot_of(law, m.root_mass));
    rubbing = less(rubbing, gripping_force(&spring, damped, law.sliding * magnitudes(pressing), law));
  }
  return rubbing;
}

INLINE Vectors rubbing_over(Vectors spring, Vectors slip, reals time, reals pressed, Meeting m, PairLaw law) {
  const Vectors way = scaled(slip, time);
  return rubbing_of(scaled(plus_scaled(spring, way, (reals)(0.5f)), time), way, pressed, m, law);
}

// What the Coulomb limit leaves of a spring.
INLINE Vectors left_of(Vectors spring, Vectors slip, reals limit, Meeting m, PairLaw law) {
  if (HISTORY && (law.history & REMEMBERS))
    gripping_force(&spring, scaled(slip, spring_dashpot_of(law, m.root_mass)), limit, law);
  return spring;
}

// Of contacts that begin, at a normal rate of `rate`. Bodies may slide from the touch on; the slip has since gained by
// a part of `gain`.
INLINE void rub_from_the_touch(Meeting* m, Onset* o, PairLaw law, reals rate, Vectors gain, real step,
                               Vectors* spring) {
  const Vectors none = vectors(0, 0, 0);
  const Vectors slip = slip_of(m->velocity, inner(m->velocity, m->normal), m->sweep, m->normal);
  const Vectors gained = HISTORY && bends(law) ? scaled(gain, o->time * (1 / step)) : none;
  const reals first_force = dashpot_of(law, m->root_mass) * rate;
  const Vectors first = left_of(none, less(slip, gained), law.sliding * magnitudes(first_force), *m, law);
  const Vectors rub = rubbing_over(first, slip, o->time, o->impulse, *m, law), change = scaled(rub, m->mobility);
  o->rub = chosen(o->begins, rub, o->rub);
  *spring = chosen(o->begins, first, *spring);
  m->stretching = chosen(o->begins, plus_scaled(slip, less(change, gained), (reals)(0.5f)), m->stretching);
  m->duration = o->begins ? o->time : m->duration;
  m->foreseen_slip = o->begins ? 1 : m->foreseen_slip;
  m->velocity = chosen(o->begins, plus_scaled(m->velocity, change, (reals)(1)), m->velocity);
}

// Of contacts that end.
INLINE void rub_to_the_end(Meeting m, Onset* o, Before b, Flow f, PairLaw law, Swing swing, Vectors spring, real step) {
  const Vectors held = HISTORY ? turned_springs(spring, m.normal, law.history) : spring;
  if (HISTORY && bends(law)) {
    o->rub = chosen(o->ends, rub_of_bent_end(m, o->ends, b, f, o->time, law, swing, held, step), o->rub);
  } else {
    const reals pressed = pressing_impulse(b, o->time, f, law, swing, m.root_mass);
    o->rub = chosen(o->ends, rubbing_over(held, b.slip, o->time, pressed, m, law), o->rub);
  }
  o->rubbed = chosen(o->ends, rubbing_of(held, b.slip, b.force, m, law), o->rubbed);
}

// Where the normal force has changed its sign since the last boundary, the Coulomb limit has passed 0. Returns what
// friction did until then, where it is followed.
INLINE Vectors turn_over(Meeting* m, flags turns, PairLaw law, Vectors* spring, real step) {
  const Before b = before_step(*m, law, step);
  const reals separating = inner(m->velocity, m->normal);
  const reals now = full_force(m->overlap, -separating, law, m->root_mass);
  const Vectors slip = slip_of(m->velocity, separating, m->sweep, m->normal);
  m->lasts = m->lasts & ~turns;
  if (bends(law) && law.lowest < 0)
    return follow_through_zero(m, turns, b, now, slip, law, spring, step);
  *spring = chosen(turns, left_of(*spring, slip, (reals)(0), *m, law), *spring);
  m->stretching = chosen(turns, slip, m->stretching);
  m->duration = turns ? step * now / (now - b.force) : m->duration;
  return vectors(0, 0, 0);
}

// Of contacts that begin, overlap and rate become those that the exact motion has come to.
INLINE Onset onset_of(Meeting* m, flags was, PairLaw law, Vectors* spring, real step, int terms) {
  const Swing swing = swing_of(law, m->root_mass, terms);
  const reals mass = m->root_mass * m->root_mass;
  const Before b = before_step(*m, law, step);
  const reals middle = -inner(m->middle_velocity, m->normal);
  Onset o;
  o.rub = o.rubbed = vectors(0, 0, 0);
  o.before = b.force;
  o.begins = m->touching & ~was;
  o.ends = was & ~m->touching;
  if (law.lowest == 0) o.ends = (b.force > 0) & (o.ends | (m->touching & was & pulling(*m, law)));
  const flags within = (middle > 0) & (m->overlap < middle * step);
  const reals since = within ? m->overlap / middle : (reals)(step);
  const reals rate = within ? middle : m->overlap / step;
  o.time = o.begins ? since : 0;
  if (any_of(o.ends)) o.time = o.ends ? time_left(b, step, law, swing) : o.time;
  const Flow f = flow_of(o.ends ? b.overlap : 0, o.ends ? b.rate : (o.begins ? rate : 0), o.time, swing);
  o.impulse = -mass * f.gain;
  o.moment = -mass * f.way;
  if (law.lowest == 0) o.impulse = (o.begins & (o.impulse < 0)) ? 0 : o.impulse;
  o.moment = o.ends ? fma(step - o.time, o.impulse, o.moment) : o.moment;
  if ((FRICTION || HISTORY) && any_of(o.ends)) rub_to_the_end(*m, &o, b, f, law, swing, *spring, step);
  const reals change = -inner(m->velocity, m->normal) - (rate + f.gain);
  m->velocity = chosen(o.begins, plus_scaled(m->velocity, m->normal, change), m->velocity);
  m->overlap = o.begins ? m->overlap + f.way : m->overlap;
  m->foreseen = o.begins ? 1 : m->foreseen;
  if ((FRICTION || HISTORY) && any_of(o.begins)) rub_from_the_touch(m, &o, law, rate, b.gain, step, spring);
  return o;
}

// What has been done, in place of what the plain scheme does.
INLINE void correct(Push* total, Meeting m, Onset o, Grasp g, real step) {
  const reals half_step = (real)0.5f * step;
  const reals plain = o.begins ? g.pressing : o.before, moved = o.ends ? half_step * step * o.before : 0;
  const flags some = o.begins | o.ends;
  const reals impulse = some ? o.impulse - half_step * plain : 0, moment = some ? o.moment - moved : 0;
  Vectors given = scaled(m.normal, impulse), way = scaled(m.normal, moment);
  if (FRICTION || HISTORY) {
    const Vectors none = vectors(0, 0, 0);
    const Vectors rub = chosen(some, plus_scaled(o.rub, chosen(o.begins, g.rubbing, o.rubbed), (reals)(-half_step)), none);
    const reals lever = o.ends ? step - (real)0.5f * o.time : (real)0.5f * o.time;
    given = plus_scaled(given, rub, (reals)(1));
    way = plus_scaled(way, chosen(some, o.rub, none), lever);
    way = plus_scaled(way, chosen(o.ends, o.rubbed, none), (reals)(-half_step * step));
    if (ROTATION) add(&total->twist, scaled(outer(m.normal, rub), -m.arm / step), total->torque_unit);
  }
  add(&total->impulse, scaled(given, (reals)(1 / step)), total->force_unit);
  add(&total->moment, scaled(way, (reals)(1 / (step * step))), total->force_unit);
  total->corrected = true;
}
