// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What acts on the second of two bodies at one contact. Every detector, for spheres and walls alike, ends here.
typedef struct {
  real3 normal;         // from the first body to the second
  real3 velocity;       // of the second's centre relative to the first's, or to the wall's surface
  real3 rolling;        // what turning takes away from the slip
  real3 spin;           // of the second relative to the first
  real3 winding;        // the same of the spins that wind a spring
  real3 surface;        // velocity of a wall's surface
  real3 wall_spin;
  real overlap;         // δ_b
  real reach_overlap;   // δ_e
  real root_mass;       // of the effective mass
  real radius;          // effective
  real arm;             // of the torque on the second
  real duration;        // for which springs are stretched, 0 at the start
  real foresight;       // time in which the contact changes the rate that its dashpots take; 0 where that is known
  bool starting;        // step 0
  int self, other;      // bodies; below 0 for a wall
  real other_arm;
  real apart;           // centres of two spheres
  Turnover turnover;
  real inverse_mass;    // effective
  global real4* memory;
  real share;           // of the contact's energy that is the second body's: 1/2, or 1 where the first never moves
} ContactPoint;

typedef struct {
  real3 force;
  Turning turning;
  Account account;
} Load;

// What a contact did, for those that change it afterwards.
typedef struct {
  real3 slip;
  real pressing;
  real3 rubbing;
  Rise rise;
} Push;
