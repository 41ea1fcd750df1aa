// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void meet_cylinders(World w, Load* load, Body self, int step) {}
