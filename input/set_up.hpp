// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "input/node.hpp"
#include "input/read_case.hpp"
#include "model/scene.hpp"

/// What one point of a sweep's numbers says, before steps and samples are resolved.
namespace grainproof::input {

/// A step as written: seconds, a fraction of the shortest contact, or the error that it may make.
struct StepWish {
  std::string label;
  double seconds = 0.0;            ///< 0 unless in seconds
  double steps_per_contact = 0.0;  ///< 0 unless relative
  Node place;
  double error = 0.0;        ///< 0 unless by error
  std::string because = {};  ///< what chose the seconds, where that was not the file
};

struct RecordWish {
  enum class Kind { every, steps, frames } kind = Kind::frames;
  double amount = 100.0;
};

/// The particles of one [[particles]] table stand together in Scene::particles.
struct Group {
  std::size_t first;
  std::vector<Node> positions;  ///< one a particle; only the fill itself where there is one
  std::vector<Node> ids;        ///< one a particle where ids are given
  Node material;
};

struct SetUp {
  Scene scene;  ///< particles in file order; step and sample times not yet resolved
  std::optional<StepWish> step;
  RecordWish record;
  std::optional<double> impact_speed;  ///< m/s, that Hertz contacts' durations are taken at
  bool beyond_stability = false;
  std::vector<Group> groups;
  std::vector<Node> walls;  ///< the [[wall]] tables; those walls are the last of the scene's
};

/// Where a particle was written.
const Node& place_of(const SetUp& set_up, std::size_t particle);

struct Reading {
  const ReadOptions& options;
  std::filesystem::path folder;  ///< files named in the scene are looked for here
};

SetUp read_set_up(const Document& document, const Reading& reading);

// One function a table; each is in a file of its name.
StepWish read_step(const Node& node);
Integrator read_integrator(const Node& node);
void read_run(const Table& table, SetUp& set_up);
void read_domain(const Table& table, Scene& scene);
void read_domain_walls(const Table& table, Scene& scene);  ///< needs the materials
void read_bodies(const Table& table, Scene& scene);
void read_materials(const Table& table, Scene& scene);
void read_contacts(const std::vector<Node>& tables, Scene& scene);  ///< needs the materials
void read_walls(const std::vector<Node>& tables, SetUp& set_up);
void read_particles(const std::vector<Node>& tables, const Reading& reading, SetUp& set_up);
void read_field(const Table& table, Scene& scene);

/// Index into Scene::materials; refuses an unknown name.
std::int32_t read_material_name(const Node& node, const Scene& scene);

/// Refuses moving particles whose material can meet one that it has no laws with.
void check_pairs_of_materials(const SetUp& set_up);

/// Refuses cylinders that particles don't fit into, and walls that a periodic face cuts.
void check_walls(const SetUp& set_up);

/// Refuses what no single table can see: particles outside, too deep in each other or in a wall, same
/// ids, pairs without laws, a periodic box that is too small, Hertz contacts without a speed.
void check_set_up(const SetUp& set_up, const Document& document);

}  // namespace grainproof::input
