// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE Push press(World w, Load* load, ContactPoint c, PairLaw law) {
  const real separating = c.velocity.x * c.normal.x + c.velocity.y * c.normal.y + c.velocity.z * c.normal.z;
  const Rise rise = rise_of(c.overlap, c.radius, law);
  const real braked = refined_rate(w, c, separating, law.stiffness * rise.slope, dashpot(law, c.root_mass) * rise.root);
  const real pressing = normal_force(c.overlap, braked, law, c.root_mass, rise);
  const real3 slip = c.velocity - separating * c.normal - c.rolling;
  real3 rubbing = friction_force(creeping(w, c, slip, law), pressing, law, c.root_mass);
  const real3 damped = refined_slip(w, c, slip, law.spring * rise.factor, spring_damping_of(law, c.root_mass, rise));
  const Turnover turnover = c.turnover.since >= 0 ? c.turnover : turnover_of(w, c, law, slip, &load->account);
  const real3 stretching = stretching_slip(w, c, slip), moved = stretching * c.duration;
  const Turn turn = turn_of(w, c, law, rise, turnover, slip, stretching);
  const real held_by = holding(w, pressing);
  const real3 taken = turnover.followed ? turnover.now : damped;
  const Strain strain = {moved, taken, c.normal, held_by, c.overlap, c.root_mass, c.share, turnover, turn};
  bend_friction(w, c, law, strain, pressing, &load->account);
  stretch_spring(&rubbing, c.memory, strain, law, rise, &load->account);
  const real3 torque = torque_of(rubbing, c.arm, c.normal);
  turn_body(&load->turning, torque);
  const real elastic = law.stiffness * rise.factor * c.overlap;
  const Rolling roll = {c.spin,  c.winding, c.wall_spin,               c.normal,   c.radius, elastic,
                        held_by, law.spring * rise.factor, c.duration, c.share,  turnover.since, c.memory};
  const real3 rolled = resist_rolling(&load->turning, roll, law, &load->account);
  const real3 force = pressing * c.normal + rubbing;
  load->force += force;
  const real3 dashpot = (pressing - elastic) * c.normal;
  enter_normal(&load->account, c.share, elastic_energy(c.overlap, law, rise), dashpot, c.surface);
  enter_friction(&load->account, rubbing, torque, c.surface);
  enter_force(&load->account, c.share, force, c.surface);
  const Push push = {slip, pressing, rubbing, rolled, rise};
  return push;
}

INLINE void attract(Load* load, ContactPoint c, PairLaw law) {
  const real3 force = -attraction(c.reach_overlap, law) * c.normal;
  load->force += force;
  enter_cohesion(&load->account, c.share, cohesive_energy(c.reach_overlap, law));
  enter_force(&load->account, c.share, force, c.surface);
}

INLINE void meet(World w, Load* load, ContactPoint c, PairLaw law) {
  c.turnover = no_turnover();
  if (c.overlap > 0) {
    const Onset onset = onset_of(w, &c, law);
    const Push push = press(w, load, c, law);
    correct_onset(w, c, law, onset, push, &load->account);
  } else {
    end_contact(w, c, law, &load->account);
    forget(c.memory);
  }
  if (reaches_farther() && c.reach_overlap > 0) attract(load, c, law);
}
