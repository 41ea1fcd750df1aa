// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// docs/laws/integrators.md, pefrl: in each of four stages a drift, the forces at its end and the kick before the next
// drift; a fifth drift ends the step. Shares of the step.
#define STAGES 4
#define MOVES_LAST 1

#define XI 0.1786178958448091
#define LAMBDA -0.2123418310626054
#define CHI -0.06626458266981849

INLINE real drift_share(int stage) {
  if (stage == 0 || stage == 4) return (real)XI;
  return stage == 2 ? (real)(1 - 2 * (CHI + XI)) : (real)CHI;
}

INLINE real kick_share(int stage) { return stage == 0 || stage == 3 ? (real)(0.5 - LAMBDA) : (real)LAMBDA; }

INLINE bool springs_only(World w) { return false; }

// No force is evaluated at a boundary: the first stage stretches for the drift before it too.
INLINE real stretch_time(World w, int step) {
  if (step == 0) return 0;
  const bool first = w.stage == 0 && step > 1;
  return w.constants->time.x * (first ? 2 * (real)XI : drift_share(w.stage));
}
