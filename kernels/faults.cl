// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// How a run goes wrong, first step and smallest index first, whatever the threads do: every particle keeps its own
// first fault, and the earliest step is an integer minimum. No kernel reads a signal that it writes.
#define STALE_AT 0       // written by movers: first step at which a list may miss a pair
#define ESCAPED_AT 1     // written by movers
#define OVERLAPPED_AT 2  // written by the force stage
#define HALTED 3         // written by the force stage

#define NOT_A_NUMBER 1
#define LEFT_DOMAIN 2
#define TOO_DEEP 3
#define LEAPT 4

INLINE void blame(World w, int i, int step, int cause, int partner, int signal) {
  if (w.faults[i].x != NEVER) return;
  w.faults[i] = (int4)(step, cause, partner, 0);
  atomic_min(&w.signals[signal], step);
}

INLINE bool movers_halt(World w, int step) { return w.signals[HALTED] != 0 || w.signals[OVERLAPPED_AT] < step; }

INLINE bool forces_halt(World w, int step) {
  return w.signals[STALE_AT] <= step || w.signals[ESCAPED_AT] <= step;
}
