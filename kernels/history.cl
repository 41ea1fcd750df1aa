// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/history.md: a tangential spring that lives as long as its contact. Each body of a pair keeps its own; the
// two are mirror images to the last bit, since nothing here depends on which body is the second but by a sign.
// The fourth component of a spring is 0 while the bodies are apart, else its energy, or this where it has none.
#define UNSTRAINED (-1)

typedef struct {
  real3 slip, normal;
  real pressing, root_mass, duration, share;
} Strain;

INLINE global real4* spring_of_pair(World w, int slot) { return w.springs + slot; }

INLINE global real4* spring_of_wall(World w, int i, int wall) {
  return w.wall_springs + i * (w.constants->counts.z + w.constants->counts.w) + wall;
}

INLINE real product_of(real3 a, real3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
INLINE real length_of(real3 a) { return square_root(product_of(a, a)); }

// Into the tangent plane of now.
INLINE real3 turned(real3 spring, real3 normal, PairLaw law) {
  const real3 flat = spring - product_of(spring, normal) * normal;
  if (law.history & TURN_PROJECTS) return flat;
  const real length = length_of(flat);
  return length > 0 ? flat * (length_of(spring) / length) : flat;
}

typedef struct {
  real3 spring;
  real3 force;  // against the slip
  bool slides;
} Grip;

// The Coulomb limit on what holds, and what it leaves of the spring.
INLINE Grip gripped(real3 spring, real3 damped, real stiffness, real limit, PairLaw law) {
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  Grip g = {spring, stiffness * spring + damped, false};
  const real held = length_of(alone ? stiffness * spring : g.force);
  if (!(held > limit)) return g;
  g.slides = true;
  if (alone) {
    g.spring = spring * (limit / held);
    g.force = stiffness * g.spring;
  } else {
    g.force *= limit / held;
    g.spring = (g.force - damped) / stiffness;
  }
  return g;
}

// Work on the spring and the dashpot, less what the spring holds more than before. While it sticks the force that
// does the work is the mean of the step's two ends.
INLINE void enter_rubbing(Strain s, Grip g, real stiffness, real before, real energy, Account* account) {
  const real work = product_of(g.force, s.slip) * s.duration;
  const real3 stretch = s.slip * s.duration;
  const real ahead = g.slides ? 0 : (real)0.5 * stiffness * product_of(stretch, stretch);
  enter_friction(account, s.share, (work - ahead - (energy - before)) / s.duration);
  enter_spring(account, s.share, energy);
}

INLINE void stretch_spring(real3* rubbing, global real4* spring, Strain s, PairLaw law, Rise rise, Account* account) {
  if (!(law.history & REMEMBERS)) return;
  const real stiffness = law.spring * rise.factor;
  const real damping = (law.spring_damping + law.spring_damping_root_mass * s.root_mass) * rise.root;
  const real4 before = *spring;
  const real3 trial = turned(before.xyz, s.normal, law) + s.slip * s.duration;
  const Grip g = gripped(trial, damping * s.slip, stiffness, law.sliding * magnitude(s.pressing), law);
  *rubbing -= g.force;
  if (s.duration > 0) {
    const real energy = (real)0.5 * stiffness * product_of(g.spring, g.spring);
    enter_rubbing(s, g, stiffness, greater_of(before.w, 0), energy, account);
    *spring = (real4)(g.spring, energy > 0 ? energy : UNSTRAINED);
  } else {
    // Before the first step nothing is stretched, so taking its forces again changes nothing.
    *spring = (real4)(0, 0, 0, UNSTRAINED);
  }
}

// A contact that has opened forgets; what its spring still held is lost.
INLINE void release_spring(global real4* spring, real share, real duration, Account* account) {
  const real energy = spring->w;
  if (energy == 0) return;
  if (energy > 0 && duration > 0) enter_friction(account, share, energy / duration);
  *spring = (real4)(0);
}
