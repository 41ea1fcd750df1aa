// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/engine.hpp"

namespace grainproof::reference {

/// What the reference cannot express, or would get wrong without a word.
Support supported(const Scene& scene);

/// Its parts about contact laws, and about what contacts remember at the start (the laws are known to be
/// fine).
Support laws_supported(const Scene& scene);
Support memories_supported(const Scene& scene);

}  // namespace grainproof::reference
