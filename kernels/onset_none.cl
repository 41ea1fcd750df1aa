// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Contacts act over whole steps.
typedef struct {
  char nothing;
} Onset;

INLINE bool was_touching(const global real4* memory) { return false; }
INLINE Onset onset_of(World w, ContactPoint* c, PairLaw law) {
  Onset o = {0};
  return o;
}
INLINE void correct_onset(World w, ContactPoint c, PairLaw law, Onset o, Push push, Account* account) {}
INLINE void end_contact(World w, ContactPoint c, PairLaw law, Account* account) {}
INLINE Turnover turnover_of(World w, ContactPoint c, PairLaw law, real3 slip, Account* account) {
  return no_turnover();
}
INLINE void bend_friction(World w, ContactPoint c, PairLaw law, Strain s, real pressing, Account* account) {}
