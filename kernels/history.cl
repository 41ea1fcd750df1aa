// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/history.md: a tangential spring that lives as long as its contact. Each body of a pair keeps its own; the
// two are mirror images to the last bit, since nothing here depends on which body is the second but by a sign.
// The fourth component of a spring is the overlap of the contact when it was stretched, 0 while the bodies are apart.
typedef struct {
  real3 moved, damped, normal;  // what stretches the spring, m, and what the dashpot takes, m/s
  real pressing, overlap, root_mass, share;
  Turnover turnover;
  Turn turn;
} Strain;

INLINE global real4* memory_of_pair(World w, int slot) { return w.springs + slot * MEMORY_WORDS; }
INLINE global real4* memory_of_wall(World w, int slot) { return w.wall_springs + slot * MEMORY_WORDS; }

INLINE real product_of(real3 a, real3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
INLINE real length_of(real3 a) { return square_root(product_of(a, a)); }

// What is left of a spring that keeps its force while the contact grows stiffer: k_t rises with the root of the overlap.
INLINE real3 kept(real4 spring, real overlap, PairLaw law) {
  const bool stiffer = (law.history & KEEPS_FORCE) && spring.w > 0 && spring.w < overlap;
  return stiffer ? spring.xyz * square_root(spring.w / overlap) : spring.xyz;
}

// Into the tangent plane of now.
INLINE real3 turned(real3 spring, real3 normal, PairLaw law) {
  const real3 flat = spring - product_of(spring, normal) * normal;
  if (law.history & TURN_PROJECTS) return flat;
  const real length = length_of(flat);
  return length > 0 ? flat * (length_of(spring) / length) : flat;
}

// Spheres that roll round each other take it with them.
INLINE real3 carried(real3 spring, Strain s, PairLaw law) {
  if (!s.turn.rolls) return turned(spring, s.normal, law);
  return spring + product_of(spring, s.normal) * (s.turn.round - s.normal);
}

typedef struct {
  real3 spring;
  real3 force;  // against the slip
} Grip;

// The Coulomb limit on what holds, and what it leaves of the spring.
INLINE Grip gripped(real3 spring, real3 damped, real stiffness, real limit, PairLaw law) {
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  Grip g = {spring, stiffness * spring + damped};
  const real held = length_of(alone ? stiffness * spring : g.force);
  if (!(held > limit)) return g;
  if (alone) {
    g.spring = spring * (limit / held);
    g.force = stiffness * g.spring;
  } else {
    g.force *= limit / held;
    g.spring = (g.force - damped) / stiffness;
  }
  return g;
}

// The limit on a force that has turned since the step's start: twice what cutting it back in either half of the step
// leaves of it, less once what doing so at the end alone leaves.
INLINE real3 cut_along(real3 before, real3 trial, real limit) {
  const real3 straight = trial / length_of(trial), middle = (real)0.5 * (before + trial);
  const real halfway = (real)0.5 * (length_of(before) + limit), reached = length_of(middle);
  if (!(reached > halfway)) return limit * straight;
  const real3 second = trial - middle * ((reached - halfway) / reached);
  const real length = length_of(second);
  if (!(length > 0)) return limit * straight;
  const real3 way = second * (2 / length) - straight;
  return way * (limit / length_of(way));
}

// As gripped(), for a spring that was `held` at the step's start and has since become `trial`.
INLINE Grip gripped_along(real3 held, real3 trial, Strain s, real stiffness, real damping, real limit, PairLaw law) {
  const bool alone = (law.history & LIMIT_ON_SPRING) != 0;
  const real3 damped = damping * s.damped;
  Grip g = {trial, stiffness * trial + damped};
  const real3 limited = alone ? stiffness * trial : g.force;
  if (!(length_of(limited) > limit)) return g;
  const real3 before = alone ? stiffness * held : stiffness * held + damping * s.turn.earlier;
  g.force = cut_along(before, limited, limit);
  g.spring = (alone ? g.force : g.force - damped) / stiffness;
  return g;
}

INLINE real spring_damping_of(PairLaw law, real root_mass, Rise rise) {
  return (law.spring_damping + law.spring_damping_root_mass * root_mass) * rise.root;
}

INLINE void stretch_spring(real3* rubbing, global real4* memory, Strain s, PairLaw law, Rise rise, Account* account) {
  if (!(law.history & REMEMBERS)) return;
  const real stiffness = law.spring * rise.factor;
  const real damping = spring_damping_of(law, s.root_mass, rise);
  const real3 damped = damping * s.damped;
  const real3 held = carried(kept(*memory, s.overlap, law), s, law);
  const real3 moved = s.moved + rest_in(memory);
  real3 trial = held + moved;
  const real3 rest = moved - (trial - held);
  if (s.turnover.since >= 0)
    trial = gripped(held, damping * s.turnover.slip, stiffness, s.turnover.limit, law).spring +
            s.turnover.way;
  const real limit = law.sliding * magnitude(s.pressing);
  const Grip g = s.turn.followed ? gripped_along(held, trial, s, stiffness, damping, limit, law)
                                 : gripped(trial, damped, stiffness, limit, law);
  *rubbing -= g.force;
  *memory = (real4)(g.spring, s.overlap);
  const bool whole = s.turnover.since < 0 && g.spring.x == trial.x && g.spring.y == trial.y && g.spring.z == trial.z;
  keep_rest(memory, whole ? rest : (real3)(0));
  enter_spring(account, s.share, (real)0.5 * stiffness * product_of(g.spring, g.spring));
}

// A contact that has opened.
INLINE void forget(global real4* memory) {
  if (memory->w == 0) return;
  for (int word = 0; word < MEMORY_WORDS; ++word) memory[word] = (real4)(0);
}
