// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Springs are laid into the plane of now, and cut back along themselves.
INLINE Turn turn_of(World w, ContactPoint c, PairLaw law, Rise rise, Turnover t, real3 slip, real3 stretching) {
  const Turn none = {false, false, (real3)(0), (real3)(0)};
  return none;
}
