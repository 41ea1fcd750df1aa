// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Andrews 6.1-6.3 with cos(φ + π/2) = −sin φ and sin(φ + π/2) = cos φ.
INLINE real3 flow_at(World w, Position p) {
  const real3 phase = phase_of(p, &w.constants->wave);
  const real3 s = (real3)(sin(phase.x), sin(phase.y), sin(phase.z));
  const real3 c = (real3)(cos(phase.x), cos(phase.y), cos(phase.z));
  const real amplitude = w.constants->stream.w;
  return (real3)(-amplitude * s.x * c.y * c.z, -amplitude * c.x * s.y * c.z, 2 * amplitude * c.x * c.y * s.z);
}

INLINE real drag_rate(World w, int i) { return w.drag_rates[i]; }
