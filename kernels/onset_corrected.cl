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

// Over a time of `way` and of an impulse of the normal force, from a spring that is there at its start.
INLINE real3 rubbing_over(real time, real3 way, real3 spring, real pressed, real stiffness, real damping, ContactPoint c,
                          PairLaw law) {
  return friction_force(way, pressed, law, c.root_mass) -
         gripping((spring + (real)0.5 * way) * time, damping * way, stiffness, law.sliding * pressed, law);
}

// Of a contact that begins, what friction has done: the slip, which has `gained` since the touch, becomes that after
// it.
INLINE void rub_from_the_touch(World w, ContactPoint* c, PairLaw law, Onset* o, real rate, real pressed, real3 gained) {
  const Rise rise = rise_of(c->overlap, c->radius, law);
  const real3 slip = c->velocity - separating_rate(*c) * c->normal - c->rolling;
  c->turnover.since = o->time;
  c->turnover.slip = slip_at_touch(slip - gained, law);
  c->turnover.limit = law.sliding * magnitude(full_force(0, -rate, law, c->root_mass, rise_of(0, c->radius, law)));
  const real stiffness = law.spring * rise.factor, damping = spring_damping_of(law, c->root_mass, rise);
  const real3 first = left_of(damping * c->turnover.slip, stiffness, c->turnover.limit, law);
  o->rub = rubbing_over(o->time, slip * o->time, first, pressed, stiffness * spring_share(law, true),
                        damping * damping_share(law), *c, law);
  const real3 change = o->rub * (c->inverse_mass + turning_mobility(w, c->self, c->arm, c->other, c->other_arm));
  c->turnover.way = (slip + (real)0.5 * (change - gained)) * o->time;
  c->velocity += change;
}

// Of a contact that begins, overlap and rate become those that the exact motion has come to.
INLINE Onset onset_of(World w, ContactPoint* c, PairLaw law) {
  Onset o = {false, 0, 0, 0, (real3)(0)};
  if (c->starting || c->memory->w != 0) return o;
  const real step = w.constants->time.x;
  real3 slip;
  const real middle = half_rate_of(w, *c, &slip);
  const bool within_step = middle > 0 && c->overlap < middle * step;
  o.begins = true;
  o.time = within_step ? c->overlap / middle : step;
  const real rate = within_step ? middle : c->overlap / step;
  const real3 gained = bends(law) ? before_step(w, *c, law).gain * (o.time / step) : (real3)(0);
  const Begun b = begun(rate, o.time, step, law, c->root_mass, c->radius);
  o.impulse = b.impulse;
  o.moment = b.moment;
  c->velocity -= (separating_rate(*c) + rate + b.gain) * c->normal;
  c->overlap += b.way;
  rub_from_the_touch(w, c, law, &o, rate, b.pressed, gained);
  c->duration = o.time;
  c->foresight = 0;
  return o;
}

INLINE void add_correction(World w, ContactPoint c, Account* account, real3 normal, real3 normal_moment, real3 rubbing,
                           real3 rubbing_moment, real3 rolled) {
  const real3 torque = torque_of(rubbing, c.arm, c.normal);
  enter_correction(w, c.self, normal + rubbing, normal_moment + rubbing_moment, torque + rolled);
  enter_event(account, c, normal, rubbing, torque, rolled);
}

INLINE void correct_onset(World w, ContactPoint c, PairLaw law, Onset o, Push push, Account* account) {
  if ((c.starting || o.begins) && !(c.memory->w > 0)) c.memory->w = greater_of(c.overlap, FLT_MIN);
  if (!o.begins) return;
  const real half_step = w.constants->time.y;
  add_correction(w, c, account, (o.impulse - half_step * push.pressing) * c.normal, o.moment * c.normal,
                 o.rub - half_step * push.rubbing, o.rub * ((real)0.5 * o.time),
                 ((real)0.5 * o.time - half_step) * push.rolled);  // grows from nothing
}

// Rolling resistance at the last boundary, before it is wound any further.
INLINE Rolling rolling_before(ContactPoint c, PairLaw law, Before b, Rise rise) {
  const real3 spin = c.winding + c.winding - c.spin;
  const Rolling r = {spin,    spin, c.wall_spin, c.normal, c.radius, law.stiffness * rise.factor * b.overlap,
                     b.force, law.spring * rise.factor, 0, c.share,  -1, c.memory};
  return r;
}

// A contact that has parted, or let go, since the last boundary.
INLINE void let_go(World w, ContactPoint c, PairLaw law, Before b, Account* account) {
  if (law.lowest == 0 && !(b.force > 0)) return;
  const real step = w.constants->time.x, half_step = w.constants->time.y;
  const Rise rise = rise_of(b.overlap, c.radius, law);
  const Ended e = ended(b, step, law, c.root_mass, c.radius);
  const real3 spring = remembered_spring(c.memory, c.normal, law);
  const real stiffness = law.spring * rise.factor, damping = spring_damping_of(law, c.root_mass, rise);
  const real3 before = friction_force(b.slip, b.force, law, c.root_mass) -
                       gripping(spring, damping * b.slip, stiffness, law.sliding * magnitude(b.force), law);
  const real share = spring_share(law, false), damped_share = damping_share(law);
  const real3 rubbing = bends(law) ? rub_to_the_end(w, c, law, b, e.time, spring)
                                   : rubbing_over(e.time, b.slip * e.time, spring, e.pressed, stiffness * share,
                                                  damping * damped_share, c, law);
  add_correction(w, c, account, (e.impulse - half_step * b.force) * c.normal,
                 (e.moment - step * half_step * b.force) * c.normal, rubbing - half_step * before,
                 (step - (real)0.5 * e.time) * rubbing - step * half_step * before,
                 rolling_to_the_end(rolling_before(c, law, b, rise), law, e.time, e.pressed, half_step));
}

INLINE void end_contact(World w, ContactPoint c, PairLaw law, Account* account) {
  if (was_touching(c.memory)) let_go(w, c, law, before_step(w, c, law), account);
}

// Where the normal force has changed its sign since the last boundary, a contact that cannot pull has let go.
INLINE Turnover turnover_of(World w, ContactPoint c, PairLaw law, real3 slip, Account* account) {
  Turnover t = no_turnover();
  const bool springs = (law.history & REMEMBERS) != 0;
  if (!(c.foresight > 0) || (law.lowest < 0 && !springs)) return t;
  const Rise rise = rise_of(c.overlap, c.radius, law);
  const real now = full_force(c.overlap, separating_rate(c), law, c.root_mass, rise);
  const Before b = before_step(w, c, law);
  if ((b.force > 0) == (now > 0)) return t;
  if (law.lowest == 0 && b.force > 0) let_go(w, c, law, b, account);
  if (!springs) return t;
  if (bends(law) && law.lowest < 0) return followed_turnover(w, c, law, b, now);
  t.since = w.constants->time.x * now / (now - b.force);
  t.slip = slip;
  t.way = slip * t.since;
  return t;
}

// Of a contact that has lasted through the step, before its spring is stretched.
INLINE void bend_friction(World w, ContactPoint c, PairLaw law, Strain s, real pressing, Account* account) {
  const Turnover t = s.turnover;
  if (!(c.foresight > 0) || !bends(law) || (t.since >= 0 && !t.followed)) return;
  const real3 rub = t.followed ? rub_of_turnover(c, law, t, pressing, w.constants->time.x)
                               : rub_of_bend(w, c, law, s, pressing);
  if (rub.x == 0 && rub.y == 0 && rub.z == 0) return;
  add_correction(w, c, account, (real3)(0), (real3)(0), rub, (real3)(0), (real3)(0));
}
