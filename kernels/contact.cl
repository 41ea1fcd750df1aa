// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What acts on the second of two bodies at one contact. Every detector, for spheres and walls alike, ends here.
typedef struct {
  real3 normal;         // from the first body to the second
  real3 velocity;       // of the second's centre relative to the first's, or to the wall's surface
  real3 rolling;        // what turning takes away from the slip
  real3 spin;           // of the second relative to the first
  real3 surface;        // velocity of a wall's surface
  real3 wall_spin;
  real overlap;         // δ_b
  real reach_overlap;   // δ_e
  real root_mass;       // of the effective mass
  real radius;          // effective
  real arm;             // of the torque on the second
  real duration;        // for which springs are stretched: a step, or 0 at the start
  global real4* memory;
  real share;           // of the contact's energy that is the second body's: 1/2, or 1 where the first never moves
} ContactPoint;

typedef struct {
  real3 force;
  Turning turning;
  Account account;
} Load;

INLINE void press(Load* load, ContactPoint c, PairLaw law) {
  const real separating = c.velocity.x * c.normal.x + c.velocity.y * c.normal.y + c.velocity.z * c.normal.z;
  const Rise rise = rise_of(c.overlap, c.radius, law);
  const real pressing = normal_force(c.overlap, separating, law, c.root_mass, rise);
  const real3 slip = c.velocity - separating * c.normal - c.rolling;
  real3 rubbing = friction_force(slip, pressing, law, c.root_mass);
  const Strain strain = {slip, c.normal, pressing, c.overlap, c.root_mass, c.duration, c.share};
  stretch_spring(&rubbing, c.memory, strain, law, rise, &load->account);
  const real3 torque = torque_of(rubbing, c.arm, c.normal);
  turn_body(&load->turning, torque);
  const real elastic = law.stiffness * rise.factor * c.overlap;
  const Rolling roll = {c.spin,     c.wall_spin, c.normal, c.radius, elastic, pressing, law.spring * rise.factor,
                        c.duration, c.share,     c.memory};
  resist_rolling(&load->turning, roll, law, &load->account);
  const real3 force = pressing * c.normal + rubbing;
  load->force += force;
  const real3 dashpot = (pressing - elastic) * c.normal;
  enter_normal(&load->account, c.share, elastic_energy(c.overlap, law, rise), dashpot, c.surface);
  enter_friction(&load->account, rubbing, torque, c.surface);
  enter_force(&load->account, c.share, force, c.surface);
}

INLINE void attract(Load* load, ContactPoint c, PairLaw law) {
  const real3 force = -attraction(c.reach_overlap, law) * c.normal;
  load->force += force;
  enter_cohesion(&load->account, c.share, cohesive_energy(c.reach_overlap, law));
  enter_force(&load->account, c.share, force, c.surface);
}

INLINE void meet(Load* load, ContactPoint c, PairLaw law) {
  if (c.overlap > 0)
    press(load, c, law);
  else
    forget(c.memory);
  if (reaches_farther() && c.reach_overlap > 0) attract(load, c, law);
}
