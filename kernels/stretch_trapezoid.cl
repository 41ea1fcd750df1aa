// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// The velocity of a boundary stretches a spring by half a step up to the force there, and by half a step after it:
// a memory is the spring half a step ahead.
INLINE real stretch_time(World w, int step) { return step > 0 ? w.constants->time.y : 0; }
INLINE real3 led_on(real3 spring, real3 rate, real ahead) { return spring + rate * ahead; }
