// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Springs are stretched by a whole step at once, with the velocity in its middle.
INLINE real stretch_time(World w, int step) { return step > 0 ? w.constants->time.x : 0; }
INLINE real3 led_on(real3 spring, real3 rate, real ahead) { return spring; }
