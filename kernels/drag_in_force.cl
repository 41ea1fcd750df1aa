// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/drag.md: (u_f − u)/τ.
INLINE real3 drag_acceleration(World w, Body self, int step) {
  return (flow_at(w, self.position) - self.velocity) * drag_rate(w, self.index);
}
