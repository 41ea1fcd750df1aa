// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Empty: gives the precompiled headers of cmake/precompiled.cmake a target to belong to.
