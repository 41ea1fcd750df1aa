// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What stretches a spring in a step is the velocity that forces take.
INLINE real3 stretching_slip(World w, ContactPoint c, real3 slip) { return slip; }
INLINE real3 winding_spin(World w, int i) { return spin_of(w, i); }
