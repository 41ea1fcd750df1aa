// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/rolling.md, constant directional torque: its size does not depend on how fast the bodies roll.
INLINE real3 constant_torque(Rolling r, PairLaw law) {
  const real rate = square_root(r.spin.x * r.spin.x + r.spin.y * r.spin.y + r.spin.z * r.spin.z);
  if (law.rolls != ROLLS_CONSTANT || !(rate > 0)) return (real3)(0);
  const real most = law.rolling * r.radius * r.elastic;
  const real3 torque = r.spin * (-most / rate);
  const real about_normal = torque.x * r.normal.x + torque.y * r.normal.y + torque.z * r.normal.z;
  return torque - about_normal * r.normal;
}
