// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/scene.hpp"
#include "report/checkpoint_file.hpp"

namespace grainproof::app {

/// Hashes of all that the course of a run follows from. Its end and its samples are not among it, so a run
/// can go on for longer than it was first asked to.
report::Fingerprints fingerprints_of(const Scene& scene);

}  // namespace grainproof::app
