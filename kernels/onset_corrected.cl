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
  real3 rub;     // impulse of friction
} Onset;

INLINE bool was_touching(const global real4* memory) { return memory->w != 0; }

// The rate of the overlap and the slip in the middle of the step that has led here.
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

// Whatever the law, a pull too.
INLINE real full_force(real overlap, real separating, PairLaw law, real root_mass, Rise rise) {
  return law.stiffness * rise.factor * overlap - dashpot(law, root_mass) * rise.root * separating;
}

// Over a time of `way` and of an impulse of the normal force, from a spring that is there at its start.
INLINE real3 rubbing_over(real time, real3 way, real3 spring, real pressed, ContactPoint c, PairLaw law, Rise rise) {
  return friction_force(way, pressed, law, c.root_mass) -
         gripping((spring + (real)0.5 * way) * time, spring_damping_of(law, c.root_mass, rise) * way,
                  law.spring * rise.factor, law.sliding * pressed, law);
}

// Of a contact that begins, what friction has done: the slip becomes that after it.
INLINE void rub_from_the_touch(World w, ContactPoint* c, PairLaw law, Onset* o, real rate) {
  const Rise rise = rise_of(c->overlap, c->radius, law);
  const real3 slip = c->velocity - separating_rate(*c) * c->normal - c->rolling;
  c->turnover.since = o->time;
  c->turnover.slip = slip;
  c->turnover.limit = law.sliding * magnitude(full_force(0, -rate, law, c->root_mass, rise_of(0, c->radius, law)));
  const real3 first = left_of(spring_damping_of(law, c->root_mass, rise) * slip, law.spring * rise.factor,
                              c->turnover.limit, law);
  o->rub = rubbing_over(o->time, slip * o->time, first, magnitude(o->impulse), *c, law, rise);
  const real3 change = o->rub * (c->inverse_mass + turning_mobility(w, c->self, c->arm, c->other, c->other_arm));
  c->turnover.way = (slip + (real)0.5 * change) * o->time;
  c->velocity += change;
}

// Of a contact that begins, overlap and rate become those that the exact motion has come to.
INLINE Onset onset_of(World w, ContactPoint* c, PairLaw law) {
  Onset o = {false, 0, 0, 0, (real3)(0)};
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
  c->overlap += f.way;
  rub_from_the_touch(w, c, law, &o, rate);
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
  add_correction(w, c, (o.impulse - half_step * push.pressing) * c.normal, o.moment * c.normal,
                 o.rub - half_step * push.rubbing, o.rub * ((real)0.5 * o.time));
}

// How a contact stood at the last boundary: its velocities were those of the middle less what led on to the prediction.
typedef struct {
  real overlap, rate;
  real3 slip;
  real force;
} Before;

INLINE Before before_step(World w, ContactPoint c, PairLaw law) {
  const real separating = separating_rate(c);
  real3 slip;
  const real middle = half_rate_of(w, c, &slip);
  Before b;
  b.overlap = greater_of(c.overlap - w.constants->time.x * middle, 0);
  b.rate = middle + middle + separating;
  b.slip = slip + slip - (c.velocity - separating * c.normal - c.rolling);
  b.force = full_force(b.overlap, -b.rate, law, c.root_mass, rise_of(b.overlap, c.radius, law));
  return b;
}

// Its impulse, were it never to change its sign, by Simpson's rule.
INLINE real pressing_impulse(Before b, real time, Flow end, PairLaw law, real root_mass) {
  const real mass = root_mass * root_mass;
  const Rise rise = rise_of(b.overlap, 0, law);
  const Flow middle = flow_of(b.overlap, b.rate, (real)0.5 * time, law.stiffness, dashpot(law, root_mass), mass);
  const real halfway = b.overlap + (real)0.5 * time * b.rate + middle.way;
  const real second = full_force(halfway, -b.rate - middle.gain, law, root_mass, rise);
  const real third = full_force(b.overlap + time * b.rate + end.way, -b.rate - end.gain, law, root_mass, rise);
  return (magnitude(b.force) + 4 * magnitude(second) + magnitude(third)) * (time / 6);
}

// Until there is no overlap left, or where the law never pulls no force, which swings as the overlap does.
INLINE real time_left(Before b, real step, PairLaw law, real damping, real mass) {
  const real apart = parting_time(b.overlap, b.rate, step, law.stiffness, damping, mass);
  if (law.lowest < 0) return apart;
  const real change = law.stiffness * b.rate - damping * b.force / mass;
  return lesser_of(apart, parting_time(b.force, change, step, law.stiffness, damping, mass));
}

// A contact that has parted, or let go, since the last boundary.
INLINE void let_go(World w, ContactPoint c, PairLaw law, Before b) {
  if (law.lowest == 0 && !(b.force > 0)) return;
  const real step = w.constants->time.x, half_step = w.constants->time.y, mass = c.root_mass * c.root_mass;
  const Rise rise = rise_of(b.overlap, c.radius, law);
  const real time = time_left(b, step, law, dashpot(law, c.root_mass), mass);
  const Flow f = flow_of(b.overlap, b.rate, time, law.stiffness, dashpot(law, c.root_mass), mass);
  const real impulse = -mass * f.gain, moment = -mass * f.way + (step - time) * impulse;
  const real pressed = pressing_impulse(b, time, f, law, c.root_mass);
  const real3 spring = remembered_spring(c.memory, b.overlap, c.normal, law);
  const real3 damped = spring_damping_of(law, c.root_mass, rise) * b.slip;
  const real3 before = friction_force(b.slip, b.force, law, c.root_mass) -
                       gripping(spring, damped, law.spring * rise.factor, law.sliding * magnitude(b.force), law);
  const real3 rubbing = rubbing_over(time, b.slip * time, spring, pressed, c, law, rise);
  add_correction(w, c, (impulse - half_step * b.force) * c.normal, (moment - step * half_step * b.force) * c.normal,
                 rubbing - half_step * before, (step - (real)0.5 * time) * rubbing - step * half_step * before);
}

INLINE void end_contact(World w, ContactPoint c, PairLaw law) {
  if (was_touching(c.memory)) let_go(w, c, law, before_step(w, c, law));
}

// Where the normal force has changed its sign since the last boundary, a contact that cannot pull has let go.
INLINE Turnover turnover_of(World w, ContactPoint c, PairLaw law, real3 slip) {
  Turnover t = no_turnover();
  const bool springs = (law.history & REMEMBERS) != 0;
  if (!(c.foresight > 0) || (law.lowest < 0 && !springs)) return t;
  const Rise rise = rise_of(c.overlap, c.radius, law);
  const real now = full_force(c.overlap, separating_rate(c), law, c.root_mass, rise);
  const Before b = before_step(w, c, law);
  if ((b.force > 0) == (now > 0)) return t;
  if (law.lowest == 0 && b.force > 0) let_go(w, c, law, b);
  if (!springs) return t;
  t.since = w.constants->time.x * now / (now - b.force);
  t.slip = slip;
  t.way = slip * t.since;
  return t;
}
