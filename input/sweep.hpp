// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <vector>

#include "input/set_up.hpp"

namespace grainproof::input {

/// Samples that start a fraction (i + 1/2)/phases of a step before the surfaces touch.
struct Onset {
  enum class Surface { body, effect };
  int phases;
  Surface at;
  Node place;
};

struct Orientations {
  int samples;
  std::int64_t seed;
  Node place;
};

/// Samples that differ in every seed of the scene.
struct Seeds {
  int samples;
  Node place;
};

/// One number of the scene, and what stands in its place in turn.
struct NumberSweep {
  std::string path;
  const toml::node* target;
  std::vector<Node> values;
};

struct IntegratorSweep {
  Integrator integrator;
  Node place;
};

/// Every list is empty, and every option unset, where the file doesn't sweep it.
struct Sweep {
  std::vector<StepWish> steps;
  std::optional<Node> step_dither;
  std::optional<Onset> onset;
  std::optional<Orientations> orientations;
  std::optional<Seeds> seeds;
  std::vector<IntegratorSweep> integrators;
  std::vector<Node> scales;
  std::vector<Node> offsets;
  std::vector<NumberSweep> numbers;

  int phases() const { return onset ? onset->phases : 1; }
  int seedings() const { return seeds ? seeds->samples : 1; }
  int rotations() const { return orientations ? orientations->samples : 1; }

  /// Scenes that it expands to; as a double, which no product of lists overflows.
  double size() const;
};

Sweep read_sweep(const Table& table, const Document& document);

/// The node at "contact.0.normal.restitution"; array elements count from 0. Refuses, at `key`, a path
/// that leads to no number of the scene.
const toml::node& number_at(const Document& document, const Node& key);

/// All points of the sweep, in file order of the steps. `sweep_place` is where its size is refused.
std::vector<ResolvedScene> expand(Document& document, const Sweep& sweep, const Reading& reading);

}  // namespace grainproof::input
