// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/rolling.md, elastic-plastic spring: wound by the rolling of the bodies over each other, up to a limit. The
// second word of a contact's memory is its torque on the body that the memory belongs to.
#define ROLLING_WORDS 1

// LIGGGHTS winds the spring of a wall faster, where it has the arm shortened.
INLINE real3 winding_on_wall(real3 spin, real radius, real overlap, PairLaw law) {
  if (law.rolls != ROLLS_SPRING || !(law.history & ARM_SHORTENED)) return spin;
  return spin * ((radius - (real)0.5 * overlap) / (radius - overlap));
}

INLINE real rolling_stiffness(Rolling r) { return r.stiffness * r.radius * r.radius; }

// Wound on and cut back.
INLINE real3 held_torque(Rolling r, PairLaw law) {
  if (law.rolls != ROLLS_SPRING) return (real3)(0);
  const real stiffness = rolling_stiffness(r);
  const real about_normal = r.winding.x * r.normal.x + r.winding.y * r.normal.y + r.winding.z * r.normal.z;
  real3 torque = r.memory[1].xyz - (r.winding - about_normal * r.normal) * (stiffness * r.duration);
  if (r.since >= 0) torque = (r.winding - about_normal * r.normal) * -(stiffness * r.since);
  const real held = square_root(torque.x * torque.x + torque.y * torque.y + torque.z * torque.z);
  const real most = law.rolling * r.radius * magnitude(r.pressing);
  if (held > most) torque *= most / held;
  return torque;
}

INLINE real3 spring_torque(Rolling r, PairLaw law, Account* account) {
  if (law.rolls != ROLLS_SPRING) return (real3)(0);
  const real3 torque = held_torque(r, law);
  r.memory[1] = (real4)(torque, 0);
  const real square = torque.x * torque.x + torque.y * torque.y + torque.z * torque.z;
  enter_wound(account, r.share, (real)0.5 * square / rolling_stiffness(r));
  return torque;
}
