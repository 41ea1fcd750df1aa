// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Torque on the second body, against its spin relative to the first.
INLINE real3 resist_rolling(Turning* turning, Rolling r, PairLaw law, Account* account) {
  const real3 torque = constant_torque(r, law) + spring_torque(r, law, account);
  turn_body(turning, torque);
  enter_rolling(account, torque, r.wall_spin);
  return torque;
}

// What a contact that ends does for a time, of an impulse of the normal force, more than its torque over half a step: a
// constant torque falls with the overlap, a spring's does not.
INLINE real3 rolling_to_the_end(Rolling r, PairLaw law, real time, real pressed, real half_step) {
  const real3 constant_part = constant_torque(r, law), plain = held_torque(r, law);
  r.duration = (real)0.5 * time;
  r.pressing = time > 0 ? pressed / time : 0;
  return ((real)0.5 * time - half_step) * constant_part + time * held_torque(r, law) - half_step * plain;
}
