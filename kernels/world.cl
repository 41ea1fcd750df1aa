// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Everything a kernel can see of a scene. opencl/layout.hpp holds the host's twins of these types; the
// sizes are compared when an engine starts.
typedef struct {
  Position gravity_centre;
  Wave wave;
  real4 gravity;    // xyz: constant, m/s²; w: magnitude of a central field
  real4 stream;     // xyz: uniform flow, m/s; w: amplitude of a vortex
  real4 time;       // step, half step (s); drift, half drift (a position's units per velocity)
  real4 limits;     // x: largest overlap, as a fraction of the smaller radius
  int4 counts;      // particles, materials, planes, rectangles
} Constants;

// Laws of one pair of materials; m is the effective mass. docs/laws/linear.md, friction.md, cohesion.md
typedef struct {
  real stiffness;
  real damping;             // η = damping + damping_root_mass sqrt(m)
  real damping_root_mass;
  real lowest;              // of the normal force: 0 where it never pulls
  real friction;            // μ
  real viscosity;           // static limit per slip speed = viscosity + viscosity_root_mass sqrt(m)
  real viscosity_root_mass;
  real cohesion;            // k_c
  real sliding;             // μ of a friction with history, docs/laws/history.md
  real spring;              // k_t
  real spring_damping;      // η_t = spring_damping + spring_damping_root_mass sqrt(m)
  real spring_damping_root_mass;
  int history;              // which variant, of the bits below
  int hertz;                // stiffnesses grow with sqrt(R* δ): docs/laws/hertz.md
} PairLaw;

#define LIMIT_ON_SPRING 1  // else on spring and dashpot together
#define ARM_SHORTENED 2    // by half the overlap
#define TURN_PROJECTS 4    // and does not rescale
#define REMEMBERS 8        // there is a spring at all

typedef struct {
  PlaneShape shape;
  int4 wall;  // x: material, y: index among the scene's walls
} Plane;

typedef struct {
  RectangleShape shape;
  int4 wall;
} Rectangle;

typedef struct {
  real4 support;  // w: power taken out by normal dashpots
  real4 weight;   // w: power taken out by friction
  real4 drag;     // w: elastic energy
  real4 other;    // x: cohesive energy
} Tally;

typedef struct {
  real4 sum[3];   // support impulse, dissipated_normal; field impulse, dissipated_tangential; work of gravity, of drag
  real4 rest[3];  // what rounding left out of the sums
} LedgerSums;

typedef struct {
  const global Box* box;
  const global Constants* constants;
  const global PairLaw* laws;
  const global Plane* planes;
  const global Rectangle* rectangles;
  const global int* materials;
  const global Reach* reaches;        // of cohesion
  const global real* drag_rates;      // 1/τ
  const global real4* gravity_table;  // by step, from table_origin
  global Position* positions;
  global real4* velocities;           // as the integrator holds them; w: 1/mass, 0 when fixed
  global real4* rests;                // what rounding left out of the velocities
  global real4* accelerations;
  global real4* reported;             // velocities at the step boundary
  global Tally* tallies;
  global LedgerSums* sums;
  global real4* spins;                // angular velocities as the integrator holds them; w: 1/inertia, 0 when fixed
  global real4* spin_rests;
  global real4* angular_accelerations;
  global real4* reported_spins;
  global real4* springs;              // a slot for every entry of the list, or of the table of all pairs
  global real4* wall_springs;         // a slot for every particle and wall; w as in history.cl
  global int4* faults;                // step, cause, partner or face
  global int* signals;
  int table_origin;
} World;

#define WORLD_PARAMETERS                                                                                   \
  const global Box *box, const global Constants *constants, const global PairLaw *laws,                    \
      const global Plane *planes, const global Rectangle *rectangles, const global int *materials,         \
      const global Reach *reaches, const global real *drag_rates, const global real4 *gravity_table,       \
      global Position *positions, global real4 *velocities, global real4 *rests,                           \
      global real4 *accelerations, global real4 *reported, global Tally *tallies, global LedgerSums *sums, \
      global real4 *spins, global real4 *spin_rests, global real4 *angular_accelerations,                  \
      global real4 *reported_spins, global real4 *springs, global real4 *wall_springs,                     \
      global int4 *faults, global int *signals, const int table_origin

#define WORLD                                                                                     \
  {box,       constants,  laws,  planes,        rectangles, materials, reaches, drag_rates, gravity_table, \
   positions, velocities, rests, accelerations, reported,   tallies,   sums,    spins,      spin_rests,    \
   angular_accelerations, reported_spins, springs, wall_springs, faults, signals, table_origin}

typedef struct {
  Position position;
  real3 velocity;
  real inverse_mass;
  int material;
  int index;
} Body;

INLINE Body load_body(World w, int i) {
  const real4 v = w.velocities[i];
  Body b;
  b.position = w.positions[i];
  b.velocity = v.xyz;
  b.inverse_mass = v.w;
  b.material = MANY_MATERIALS ? w.materials[i] : 0;
  b.index = i;
  return b;
}

INLINE PairLaw law_between(World w, int a, int b) { return w.laws[a * w.constants->counts.y + b]; }
