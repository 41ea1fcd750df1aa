// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
INLINE void enter_event(Account* account, ContactPoint c, real3 normal, real3 rubbing, real3 torque, real3 rolled) {}
