// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What acts on the second of two bodies at one contact. Every detector, for spheres and walls alike, ends here.
typedef struct {
  real3 normal;         // from the first body to the second
  real3 velocity;       // of the second's centre relative to the first's
  real3 rolling;        // what turning takes away from the slip
  real overlap;         // δ_b
  real reach_overlap;   // δ_e
  real root_mass;       // of the effective mass
  real radius;          // effective
  real arm;             // of the torque on the second
  real duration;        // for which springs are stretched: a step, or 0 at the start
  global real4* spring;
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
  enter_friction(&load->account, c.share, -(rubbing.x * slip.x + rubbing.y * slip.y + rubbing.z * slip.z));
  const Strain strain = {slip, c.normal, pressing, c.root_mass, c.duration, c.share};
  stretch_spring(&rubbing, c.spring, strain, law, rise, &load->account);
  turn_body(&load->turning, c.arm, c.normal, rubbing);
  const real3 force = pressing * c.normal + rubbing;
  load->force += force;
  const real lost = separating * (law.stiffness * rise.factor * c.overlap - pressing);
  enter_normal(&load->account, c.share, lost, elastic_energy(c.overlap, law, rise));
  enter_force(&load->account, c.share, force);
}

INLINE void attract(Load* load, ContactPoint c, PairLaw law) {
  const real3 force = -attraction(c.reach_overlap, law) * c.normal;
  load->force += force;
  enter_cohesion(&load->account, c.share, cohesive_energy(c.reach_overlap, law));
  enter_force(&load->account, c.share, force);
}

INLINE void meet(Load* load, ContactPoint c, PairLaw law) {
  if (c.overlap > 0)
    press(load, c, law);
  else
    release_spring(c.spring, c.share, c.duration, &load->account);
  if (reaches_farther() && c.reach_overlap > 0) attract(load, c, law);
}
