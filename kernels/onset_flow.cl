// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The normal motion of m δ'' + η δ' + k δ = 0 from an overlap and its rate, by its power series: the same for
// oscillating, critical and over-damped contacts, and nothing cancels where the time is short. Within the limit on the
// step its arguments stay below 4, for which so many terms reach the last digit of a double.
#define FLOW_TERMS 24
#define FLOW_END ((real)0x1p-58)

typedef struct {
  real way;   // δ − δ_0 − u_0 t
  real gain;  // u − u_0
} Flow;

INLINE Flow flow_of(real overlap, real rate, real time, real stiffness, real damping, real mass) {
  const real p = damping / mass * time, q = stiffness / mass * time * time;
  real before = overlap, now = rate * time, way = 0, gain = 0;
  for (int n = 2; n < FLOW_TERMS; ++n) {
    const real next = -((n - 1) * p * now + q * before) / (real)(n * (n - 1));
    way += next;
    gain += n * next;
    before = now;
    now = next;
    if (!(magnitude(now) + magnitude(before) > FLOW_END * magnitude(way))) break;
  }
  const Flow f = {way, time > 0 ? gain / time : 0};
  return f;
}

// Newton's steps double the digits: after one this small there is nothing left to find, and the rest is rounding.
#define PARTING_END ((real)0x1p-30)

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
    const real earlier = time;
    time = lesser_of(greater_of(time - (overlap + rate * time + f.way) / (rate + f.gain), 0), longest);
    if (!(magnitude(time - earlier) > PARTING_END * time)) break;
  }
  return time;
}
