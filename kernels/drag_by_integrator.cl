// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// None among the forces: there is no fluid, or the integrator takes care of it.
INLINE real3 drag_acceleration(World w, Body self, int step) { return (real3)(0); }
