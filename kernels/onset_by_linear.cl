// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Every contact that begins or ends is linear.
INLINE Begun begun(real rate, real time, real step, PairLaw law, real root_mass, real radius) {
  return linear_begun(rate, time, law, root_mass);
}
INLINE Ended ended(Before b, real step, PairLaw law, real root_mass, real radius) {
  return linear_ended(b, step, law, root_mass);
}
INLINE real3 slip_at_touch(real3 slip, PairLaw law) { return slip; }
INLINE real spring_share(PairLaw law, bool begins) { return 1; }
INLINE real damping_share(PairLaw law) { return 1; }
