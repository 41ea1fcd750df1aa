// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The normal motion of m δ'' + η δ' + k δ = 0 from an overlap and its rate, by its power series: the same for
// oscillating, critical and over-damped contacts, and nothing cancels where the time is short. Within the limit on the
// step its arguments stay below 4, for which so many terms reach the last digit of a double.
#define FLOW_TERMS 24

typedef struct {
  real way;   // δ − δ_0 − u_0 t
  real gain;  // u − u_0
} Flow;

INLINE Flow flow_of(real overlap, real rate, real time, real stiffness, real damping, real mass) {
  const real p = damping / mass * time, q = stiffness / mass * time * time;
  real before = overlap, now = rate * time, way = 0, gain = 0;
  for (int n = 2; n < FLOW_TERMS; ++n) {
    const real next = -(p * now + q * before / (real)(n - 1)) / (real)n;
    way += next;
    gain += n * next;
    before = now;
    now = next;
  }
  const Flow f = {way, time > 0 ? gain / time : 0};
  return f;
}

// When a contact that parts has no overlap left, by Newton's steps from the straight way; `longest` where it never
// comes to that.
INLINE real parting_time(real overlap, real rate, real longest, real stiffness, real damping, real mass) {
  const Flow whole = flow_of(overlap, rate, longest, stiffness, damping, mass);
  if (!(overlap > 0)) return 0;
  if (!(rate < 0) || overlap + rate * longest + whole.way > 0) return longest;
  real time = lesser_of(overlap / -rate, longest);
  for (int k = 0; k < 6; ++k) {
    const Flow f = flow_of(overlap, rate, time, stiffness, damping, mass);
    if (!(rate + f.gain < 0)) return longest;
    time = lesser_of(greater_of(time - (overlap + rate * time + f.way) / (rate + f.gain), 0), longest);
  }
  return time;
}
