// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "input/fills.hpp"
#include "input/uniform.hpp"

namespace grainproof::input {
namespace {

enum class FillKind { lattice, random, file };
constexpr std::pair<std::string_view, FillKind> fill_kinds[] = {
    {"lattice", FillKind::lattice}, {"random", FillKind::random}, {"file", FillKind::file}};

/// What all particles of a table have in common.
Particle read_common(const Table& table, const Scene& scene) {
  Particle common{};
  common.material = read_material_name(table.at("material"), scene);
  const Node diameter = table.at("diameter");
  common.diameter = diameter.positive();
  const double mass = scene.materials[common.material].density * std::pow(common.diameter, 3);
  if (!std::isfinite(mass) || mass < std::numeric_limits<double>::min())
    diameter.refuse("a diameter whose mass can be written as a number");
  const auto effect = table.find("effect_diameter");
  common.effect_diameter = effect ? effect->positive() : common.diameter;
  if (common.effect_diameter < common.diameter)
    effect->refuse("at least the body's diameter, " + diameter.label());
  common.fixed = table.boolean("fixed", false);
  common.velocity = Vec3::Zero();
  return common;
}

std::vector<Node> read_one_each(const Table& table, std::string_view key, std::size_t count) {
  const auto node = table.find(key);
  if (!node) return {};
  auto elements = node->elements();
  if (elements.size() != count)
    node->refuse(std::string(key) + " of " + std::to_string(elements.size()),
                 "one for each of the " + std::to_string(count) + " positions");
  return elements;
}

void refuse_motion(const Particle& common, const Node& node) {
  if (common.fixed) node.refuse("no velocity, since fixed particles never move");
}

void read_spins(const Table& table, const Particle& common, bool rotation, std::vector<Filled>& filled) {
  const auto spins = read_one_each(table, "angular_velocities", filled.size());
  if (!spins.empty() && !rotation)
    table.at("angular_velocities")
        .refuse("angular_velocities in a scene without rotation", "rotation = true in [bodies]");
  for (std::size_t i = 0; i < spins.size(); ++i) {
    filled[i].angular_velocity = spins[i].vector();
    if (!filled[i].angular_velocity.isZero(0.0)) refuse_motion(common, spins[i]);
  }
}

std::vector<Filled> read_explicit(const Table& table, Group& group, const Particle& common, bool rotation) {
  table.only({"material", "diameter", "effect_diameter", "fixed", "positions", "velocities",
              "angular_velocities", "ids"});
  group.positions = table.at("positions").at_least_one();
  const auto velocities = read_one_each(table, "velocities", group.positions.size());
  group.ids = read_one_each(table, "ids", group.positions.size());
  std::vector<Filled> filled;
  for (std::size_t i = 0; i < group.positions.size(); ++i) {
    filled.push_back({group.positions[i].vector(), {}, {}, Vec3::Zero()});
    if (!velocities.empty()) filled.back().velocity = velocities[i].vector();
    if (!group.ids.empty()) filled.back().id = group.ids[i].integer_within(1, largest_id);
    if (filled.back().velocity && !filled.back().velocity->isZero(0.0)) refuse_motion(common, velocities[i]);
  }
  read_spins(table, common, rotation, filled);
  return filled;
}

std::vector<Filled> read_fill(const Table& table, const Particle& common, const Reading& reading,
                              const Scene& scene) {
  const std::size_t largest = reading.options.most_particles - scene.particles.size();
  const Table fill = table.at("fill").table();
  switch (fill.at("kind").choice(fill_kinds)) {
    case FillKind::lattice:
      return fill_lattice(fill, common.diameter, largest);
    case FillKind::random:
      return fill_random(fill, common.diameter, scene, largest);
    case FillKind::file:
      return fill_from_file(fill, reading.folder, largest);
  }
  return {};
}

/// `velocity` is added to all, `random_speed` bounds what each component gets besides.
void set_in_motion(const Table& table, const Particle& common, std::vector<Filled>& filled) {
  const auto velocity = table.find("velocity");
  const auto speed = table.find("random_speed");
  if (velocity) refuse_motion(common, *velocity);
  if (speed) refuse_motion(common, *speed);
  if (!speed && table.has("seed")) table.at("seed").refuse("no seed without random_speed");
  const Vec3 mean = velocity ? velocity->vector() : Vec3::Zero();
  const double amplitude = speed ? speed->not_negative() : 0.0;
  Uniform uniform(speed ? table.at("seed").integer_within(0, largest_seed) : 0);
  for (Filled& particle : filled) {
    if (particle.velocity && !particle.velocity->isZero(0.0)) refuse_motion(common, table.at("fill"));
    particle.velocity = particle.velocity.value_or(Vec3::Zero()) + mean;
    if (speed) *particle.velocity += amplitude * uniform.in_cube();
  }
}

void append(const std::vector<Filled>& filled, const Particle& common, Scene& scene) {
  std::int64_t next = 1;
  for (const Particle& particle : scene.particles) next = std::max(next, particle.id + 1);
  for (const Filled& one : filled) {
    Particle particle = common;
    particle.position = one.position;
    particle.velocity = common.fixed ? Vec3::Zero() : one.velocity.value_or(Vec3::Zero());
    particle.angular_velocity = one.angular_velocity;
    particle.id = one.id.value_or(next);
    next = std::max(next, particle.id) + 1;
    scene.particles.push_back(particle);
  }
}

void read_group(const Table& table, const Reading& reading, SetUp& set_up) {
  const auto fill = table.find("fill");
  if (fill && table.has("positions")) fill->refuse("both positions and fill", "one of the two");
  if (fill)
    table.only(
        {"material", "diameter", "effect_diameter", "fixed", "fill", "velocity", "random_speed", "seed"});
  Group group{set_up.scene.particles.size(), {}, {}, table.at("material")};
  const Particle common = read_common(table, set_up.scene);
  std::vector<Filled> filled;
  if (fill) {
    group.positions = {*fill};
    filled = read_fill(table, common, reading, set_up.scene);
    set_in_motion(table, common, filled);
  } else {
    filled = read_explicit(table, group, common, set_up.scene.rotation);
  }
  append(filled, common, set_up.scene);
  set_up.groups.push_back(std::move(group));
}

}  // namespace

void read_particles(const std::vector<Node>& tables, const Reading& reading, SetUp& set_up) {
  for (const Node& node : tables) read_group(node.table(), reading, set_up);
}

}  // namespace grainproof::input
