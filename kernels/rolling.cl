// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Torque on the second body, against its spin relative to the first.
INLINE void resist_rolling(Turning* turning, Rolling r, PairLaw law, Account* account) {
  const real3 torque = constant_torque(r, law) + spring_torque(r, law, account);
  turn_body(turning, torque);
  enter_rolling(account, torque, r.wall_spin);
}
