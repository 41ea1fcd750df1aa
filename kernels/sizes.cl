// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// What the host compares with its own idea of these types: opencl/program.cpp.
kernel void sizes(global int* bytes) {
  bytes[0] = sizeof(Position);
  bytes[1] = sizeof(Reach);
  bytes[2] = sizeof(Box);
  bytes[3] = sizeof(Constants);
  bytes[4] = sizeof(PairLaw);
  bytes[5] = sizeof(Plane);
  bytes[6] = sizeof(Rectangle);
  bytes[7] = sizeof(Tally);
  bytes[8] = sizeof(LedgerSums);
  bytes[9] = sizeof(Cylinder);
  bytes[10] = sizeof(Stand);
  bytes[11] = sizeof(WallTally);
  bytes[12] = sizeof(WallSums);
}
