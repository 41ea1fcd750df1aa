// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// A step ends with its forces.
INLINE void complete(World w, int i, int step) {}
