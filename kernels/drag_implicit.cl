// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/drag.md, with the velocity that the drag leaves in half a step by itself, as dashpots have it.
INLINE real3 drag_acceleration(World w, Body self, int step) {
  if (springs_only(w)) return (real3)(0);
  const real rate = drag_rate(w, self.index);
  return (flow_at(w, self.position) - self.velocity) * (step > 0 ? rate / (1 + w.constants->time.y * rate) : rate);
}
