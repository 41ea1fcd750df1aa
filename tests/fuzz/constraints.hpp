// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "input/read_case.hpp"

namespace grainproof::fuzz {

/// The first constraint of docs/scene.md that an accepted case breaks, in words; empty where it keeps them
/// all. Written from the document and by brute force: it shares nothing with the reader.
std::string broken_constraint(const Case& read, const ReadOptions& options);

/// The same of one scene's laws, of its particles and walls, and of its run.
std::string broken_law(const Scene& scene);
std::string broken_body(const Scene& scene);
std::string broken_wall(const Scene& scene);

}  // namespace grainproof::fuzz
