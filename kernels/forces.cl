// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE Load no_load() {
  Load load = {(real3)(0), no_turning(), new_account()};
  return load;
}

// Walls, gravity and drag after the spheres; then the sum becomes an acceleration.
INLINE void finish_forces(World w, Load load, Body self, int step) {
  meet_planes(w, &load, self, step);
  meet_rectangles(w, &load, self, step);
  meet_cylinders(w, &load, self, step);
  const real3 gravity = gravity_at(w, self.position, step);
  const real3 drag = drag_acceleration(w, self, step);
  w.accelerations[self.index] = (real4)(load.force * self.inverse_mass + gravity + drag, 0);
  close_turning(w, self.index, load.turning);
  if (!springs_only(w)) close_account(w, self.index, load.account, gravity, drag, step);
  book_events(w, self.index, load.account);
}
