// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md. In the step in which a contact begins or ends it acts for the time that it lasted: the
// normal motion is followed exactly over that time, tangential forces along the slip, and what the plain scheme does
// instead is taken off. Impulses are those on the second body; the other works out their mirror images.
typedef struct {
  bool begins;
  real time;     // in contact
  real impulse;  // of the normal force
  real moment;   // of it, over what is left of the step
} Onset;

INLINE bool was_touching(const global real4* memory) { return memory->w != 0; }

INLINE real half_rate_of(World w, ContactPoint c, real3* slip) {
  const real3 other = c.other >= 0 ? w.middles[c.other].xyz : c.surface;
  const real3 velocity = w.middles[c.self].xyz - other;
  const real separating = velocity.x * c.normal.x + velocity.y * c.normal.y + velocity.z * c.normal.z;
  *slip = velocity - separating * c.normal - rolling_in(w.spin_middles, c.self, c.arm, c.other, c.other_arm, c.normal);
  return -separating;
}

INLINE real separating_rate(ContactPoint c) {
  return c.velocity.x * c.normal.x + c.velocity.y * c.normal.y + c.velocity.z * c.normal.z;
}

// What the rate becomes by what the contact itself will do in the half step to come; 1 + c over 1 + c + κ.
INLINE real refinement(real step, real inverse_mass, real stiffness, real damping) {
  const real braked = 1 + (real)0.5 * step * damping * inverse_mass;
  return braked / (braked + (real)0.5 * step * step * stiffness * inverse_mass);
}

INLINE real refined_rate(World w, ContactPoint c, real rate, real stiffness, real damping) {
  return rate * refinement(c.foresight, c.inverse_mass, stiffness, damping);
}

INLINE real3 refined_slip(World w, ContactPoint c, real3 slip, real stiffness, real damping) {
  const real mobility = c.inverse_mass + turning_mobility(w, c.self, c.arm, c.other, c.other_arm);
  return slip * refinement(c.foresight, mobility, stiffness, damping);
}

// Of a contact that begins, overlap and rate become those that the exact motion has come to.
INLINE Onset onset_of(World w, ContactPoint* c, PairLaw law) {
  Onset o = {false, 0, 0, 0};
  if (c->starting || c->memory->w != 0) return o;
  const real step = w.constants->time.x, mass = c->root_mass * c->root_mass;
  real3 slip;
  const real middle = half_rate_of(w, *c, &slip);
  const bool within_step = middle > 0 && c->overlap < middle * step;
  o.begins = true;
  o.time = within_step ? c->overlap / middle : step;
  const real rate = within_step ? middle : c->overlap / step;
  const Flow f = flow_of(0, rate, o.time, law.stiffness, dashpot(law, c->root_mass), mass);
  o.impulse = -mass * f.gain;
  o.moment = -mass * f.way;
  if (law.lowest == 0) o.impulse = greater_of(o.impulse, 0);
  c->velocity -= (separating_rate(*c) + rate + f.gain) * c->normal;
  const real3 now = c->velocity - separating_rate(*c) * c->normal - c->rolling;
  c->turnover.since = o.time;
  c->turnover.slip = now + (2 * (o.time / step)) * (slip - now);
  c->turnover.limit = law.sliding * magnitude(normal_force(0, -rate, law, c->root_mass, rise_of(0, c->radius, law)));
  c->overlap += f.way;
  c->duration = o.time;
  c->foresight = 0;
  return o;
}

INLINE void add_correction(World w, ContactPoint c, real3 normal, real3 normal_moment, real3 rubbing,
                           real3 rubbing_moment) {
  enter_correction(w, c.self, normal + rubbing, normal_moment + rubbing_moment, torque_of(rubbing, c.arm, c.normal));
}

INLINE void correct_onset(World w, ContactPoint c, PairLaw law, Onset o, Push push) {
  if ((c.starting || o.begins) && !(c.memory->w > 0)) c.memory->w = greater_of(c.overlap, FLT_MIN);
  if (!o.begins) return;
  const real half_step = w.constants->time.y;
  const real damping = spring_damping_of(law, c.root_mass, push.rise);
  const real3 way = push.slip * o.time;
  const real stiffness = law.spring * push.rise.factor;
  const real3 first = left_of(damping * c.turnover.slip, stiffness, c.turnover.limit, law);
  const real3 rubbing = friction_force(way, o.impulse, law, c.root_mass) -
                        gripping((first + (real)0.5 * way) * o.time, damping * way, stiffness,
                                 law.sliding * o.impulse, law);
  add_correction(w, c, (o.impulse - half_step * push.pressing) * c.normal, o.moment * c.normal,
                 rubbing - half_step * push.rubbing, rubbing * ((real)0.5 * o.time));
}

// Of a contact that pulls and pressed at the last boundary. Slips go evenly from the one there, 2 s½ − ŝ, to that of
// now.
INLINE Turnover turnover_of(World w, ContactPoint c, PairLaw law, real pressing, real3 slip) {
  Turnover t = no_turnover();
  if (!(pressing < 0) || !(c.foresight > 0) || !(law.history & REMEMBERS)) return t;
  const real step = w.constants->time.x;
  real3 half_slip;
  const real middle = half_rate_of(w, c, &half_slip);
  const real overlap = c.overlap - step * middle, rate = middle + middle + separating_rate(c);
  const real before = normal_force(overlap, -rate, law, c.root_mass, rise_of(greater_of(overlap, 0), c.radius, law));
  if (!(before > 0)) return t;
  const real share = pressing / (pressing - before);
  t.since = step * share;
  t.slip = slip + 2 * share * (half_slip - slip);
  return t;
}

INLINE real pressing_impulse(real overlap, real rate, real time, Flow end, PairLaw law, real root_mass,
                             real damping) {
  const real mass = root_mass * root_mass;
  const Rise rise = rise_of(overlap, 0, law);
  const Flow middle = flow_of(overlap, rate, (real)0.5 * time, law.stiffness, damping, mass);
  const real first = normal_force(overlap, -rate, law, root_mass, rise);
  const real halfway = overlap + (real)0.5 * time * rate + middle.way;
  const real second = normal_force(halfway, -rate - middle.gain, law, root_mass, rise);
  const real third = normal_force(overlap + time * rate + end.way, -rate - end.gain, law, root_mass, rise);
  return (magnitude(first) + 4 * magnitude(second) + magnitude(third)) * (time / 6);
}

// A contact that has parted since the last boundary. Velocities there were those of the middle less what led on to the
// prediction.
INLINE void end_contact(World w, ContactPoint c, PairLaw law) {
  if (!was_touching(c.memory)) return;
  const real step = w.constants->time.x, half_step = w.constants->time.y, mass = c.root_mass * c.root_mass;
  const real damping = dashpot(law, c.root_mass);
  const real separating = separating_rate(c);
  real3 slip;
  const real middle = half_rate_of(w, c, &slip);
  slip = slip + slip - (c.velocity - separating * c.normal - c.rolling);
  const real overlap = c.overlap - step * middle, rate = middle + middle + separating;
  const Rise rise = rise_of(greater_of(overlap, 0), c.radius, law);
  const real time = parting_time(overlap, rate, step, law.stiffness, damping, mass);
  const Flow f = flow_of(overlap, rate, time, law.stiffness, damping, mass);
  real impulse = -mass * f.gain, moment = -mass * f.way + (step - time) * impulse;
  if (law.lowest == 0) {
    impulse = greater_of(impulse, 0);
    moment = greater_of(moment, 0);
  }
  const real plain = normal_force(overlap, -rate, law, c.root_mass, rise);
  const real pressed = pressing_impulse(overlap, rate, time, f, law, c.root_mass, damping);
  const real3 spring = remembered_spring(c.memory, overlap, c.normal, law) - slip * half_step;
  const real3 damped = spring_damping_of(law, c.root_mass, rise) * slip;
  const real stiffness = law.spring * rise.factor;
  const real3 before = friction_force(slip, plain, law, c.root_mass) -
                       gripping(spring, damped, stiffness, law.sliding * magnitude(plain), law);
  const real3 rubbing = friction_force(slip * time, pressed, law, c.root_mass) -
                        gripping(spring * time + slip * ((real)0.5 * time * time), damped * time, stiffness,
                                 law.sliding * pressed, law);
  add_correction(w, c, (impulse - half_step * plain) * c.normal, (moment - step * half_step * plain) * c.normal,
                 rubbing - half_step * before,
                 (step - (real)0.5 * time) * rubbing - step * half_step * before);
}
