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
  real4 limits;     // x: largest overlap, as a fraction of the smaller radius; y: 1 where bodies may leap over others;
                    // z: what rounding has left out of the step (s)
  int4 counts;      // particles, materials, planes, rectangles
  int4 walls;       // all, cylinders, moving
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
  real rolling;             // coefficient of rolling resistance
  int rolls;                // which law of it, 0 for none
  int history;              // which variant, of the bits below
  int hertz;                // stiffnesses grow with sqrt(R* δ): docs/laws/hertz.md
} PairLaw;

#define LIMIT_ON_SPRING 1  // else on spring and dashpot together
#define ARM_SHORTENED 2    // by half the overlap
#define TURN_PROJECTS 4    // and does not rescale
#define REMEMBERS 8        // there is a spring at all
#define KEEPS_FORCE 16     // while the contact grows stiffer

#define ROLLS_CONSTANT 1
#define ROLLS_SPRING 2

typedef struct {
  real4 velocity;  // where the shape is held, of a wall that turns
  real4 spin;
  real4 offset;    // from the wall's reference point to where its shape is held
  int4 wall;       // material, index among the scene's walls, row among those that move or -1, 1 if inside a cylinder
} Surface;

typedef struct {
  PlaneShape shape;
  Surface surface;
} Plane;

typedef struct {
  RectangleShape shape;
  Surface surface;
} Rectangle;

typedef struct {
  CylinderShape shape;
  Surface surface;
} Cylinder;

// Where a wall is at one step; planes and cylinders go through the centre.
typedef struct {
  RectangleShape shape;
  real4 velocity;
  real4 offset;
  int tracked;
} Stand;

typedef struct {
  real4 support;    // w: power of walls on normal dashpots
  real4 weight;     // w: power of walls on friction
  real4 drag;       // w: energy of normal springs
  real4 other;      // energies: cohesive, of tangential springs, of rolling springs; w: power of walls
  real4 braking;    // forces of normal dashpots; w: power of walls on rolling resistance
  real4 rubbing;    // forces of friction
  real4 twisting;   // torques of friction
  real4 resisting;  // torques of rolling resistance
} Tally;

typedef struct {
  real4 sum[3];   // kernels/booking.cl
  real4 rest[3];  // what rounding left out of the sums
  real4 start;    // Tally::other of step 0
} LedgerSums;

// Of one wall on one particle.
typedef struct {
  real4 force;
  real4 moment;  // about the wall's reference point
} WallTally;

typedef struct {
  real4 sum[2];
  real4 rest[2];
} WallSums;

typedef struct {
  const global Box* box;
  const global Constants* constants;
  const global PairLaw* laws;
  const global Plane* planes;
  const global Rectangle* rectangles;
  const global Cylinder* cylinders;
  const global int* materials;
  const global Reach* reaches;        // of cohesion
  const global real* drag_rates;      // 1/τ
  const global real4* gravity_table;  // by step, from table_origin
  const global Stand* stands;         // of moving walls, likewise
  global Position* positions;
  global real4* velocities;           // as the integrator holds them; w: 1/mass, 0 when fixed
  global real4* rests;                // what rounding left out of the velocities
  global real4* accelerations;
  global real4* reported;             // velocities at the step boundary
  global Tally* tallies;
  global LedgerSums* sums;
  global WallTally* wall_tallies;     // a slot for every particle and wall, as for springs
  global WallSums* wall_sums;
  global real4* spins;                // angular velocities as the integrator holds them; w: 1/inertia, 0 when fixed
  global real4* spin_rests;
  global real4* angular_accelerations;
  global real4* reported_spins;
  global real4* orientations;         // quaternions, the scalar last
  global real4* orientation_rests;
  global real4* middles;              // velocities in the middle of the step, where forces take predicted ones
  global real4* spin_middles;
  global real4* corrections;          // kernels/corrections_kept.cl
  global real4* springs;              // a memory for every entry of the list, or of the table of all pairs
  global real4* wall_springs;         // for every particle and wall: planes, rectangles, cylinders
  global int4* faults;                // step, cause, partner or face
  global int* signals;
  int table_origin;
  int stage;                          // of the step, where forces are evaluated more than once in it
} World;

#define WORLD_PARAMETERS                                                                                   \
  const global Box *box, const global Constants *constants, const global PairLaw *laws,                    \
      const global Plane *planes, const global Rectangle *rectangles, const global Cylinder *cylinders,    \
      const global int *materials, const global Reach *reaches, const global real *drag_rates,             \
      const global real4 *gravity_table, const global Stand *stands, global Position *positions,           \
      global real4 *velocities, global real4 *rests, global real4 *accelerations, global real4 *reported,  \
      global Tally *tallies, global LedgerSums *sums, global WallTally *wall_tallies,                      \
      global WallSums *wall_sums, global real4 *spins, global real4 *spin_rests,                           \
      global real4 *angular_accelerations, global real4 *reported_spins, global real4 *orientations,       \
      global real4 *orientation_rests, global real4 *middles, global real4 *spin_middles,                  \
      global real4 *corrections, global real4 *springs, global real4 *wall_springs,                        \
      global int4 *faults, global int *signals, const int table_origin

#define WORLD                                                                                              \
  {box,       constants,  laws,         planes,        rectangles, cylinders,             materials,       \
   reaches,   drag_rates, gravity_table, stands,       positions,  velocities,            rests,           \
   accelerations, reported, tallies,    sums,          wall_tallies, wall_sums,           spins,           \
   spin_rests, angular_accelerations,   reported_spins, orientations, orientation_rests,  middles,         \
   spin_middles, corrections, springs,  wall_springs,  faults,     signals,               table_origin}

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

INLINE int walls_of(World w) { return w.constants->walls.x; }
