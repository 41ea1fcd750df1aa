// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <stdexcept>
#include <string>

#include "input/read_case.hpp"

namespace grainproof {

/// A scene with one of everything: two spheres about to touch, a floor, gravity.
inline const std::string example = R"(schema = 1
title = "Example"

[run]
end = 0.01
step = "contact/64"

[domain]
lower = [-1.0, -1.0, -1.0]
upper = [1.0, 1.0, 1.0]

[material.glass]
density = 2000.0

[material.steel]
density = 7800.0

[[contact]]
between = ["glass", "glass"]
normal = { law = "linear", stiffness = 1e5, restitution = 0.8 }

[[contact]]
between = ["glass", "steel"]
normal = { law = "linear", stiffness = 1e6, restitution = 0.9 }

[[wall]]
name = "floor"
material = "steel"
plane = { point = [0.0, 0.0, -0.5], normal = [0.0, 0.0, 1.0] }

[[particles]]
material = "glass"
diameter = 0.1
fixed = true
positions = [[0.0, 0.0, 0.0]]

[[particles]]
material = "glass"
diameter = 0.1
positions = [[0.1, 0.0, 0.0], [0.1, 0.5, 0.0]]
velocities = [[-2.0, 0.0, 0.0], [0.0, 0.0, 0.0]]

[field]
gravity = [0.0, 0.0, -9.81]
)";

/// `text` with one passage put in place of another, which must be there.
inline std::string with(std::string text, const std::string& there, const std::string& instead) {
  const auto at = text.find(there);
  if (at == std::string::npos) throw std::logic_error("the example has no " + there);
  return text.replace(at, there.size(), instead);
}

inline std::string example_with(const std::string& there, const std::string& instead) {
  return with(example, there, instead);
}

inline Case read_text(const std::string& text, const ReadOptions& options = {}) {
  return read_case_text(text, "scene.toml", options);
}

/// Number of the line on which a passage begins.
inline std::size_t line_of(const std::string& text, const std::string& passage) {
  const auto at = text.find(passage);
  if (at == std::string::npos) throw std::logic_error("the text has no " + passage);
  return 1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
}

}  // namespace grainproof
