// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Dashpots see the velocities of the moment.
INLINE real refined_rate(World w, ContactPoint c, real rate, real stiffness, real damping) { return rate; }
INLINE real3 refined_slip(World w, ContactPoint c, real3 slip, real stiffness, real damping) { return slip; }
