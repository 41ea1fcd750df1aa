// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "input/fills.hpp"
#include "input/mass.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

enum class FillKind { lattice, random, file };
constexpr std::pair<std::string_view, FillKind> fill_kinds[] = {
    {"lattice", FillKind::lattice}, {"random", FillKind::random}, {"file", FillKind::file}};

void check_mass(const Node& place, double density, double diameter) {
  if (!has_a_mass(density, diameter)) place.refuse("a diameter whose mass can be written as a number");
}

/// What all particles of a table have in common; diameters are each particle's own.
Particle read_common(const Table& table, const Scene& scene) {
  Particle common{};
  common.material = read_material_name(table.at("material"), scene);
  const auto effect = table.find("effect_diameter");
  common.effect_diameter = effect ? effect->positive() : 0.0;
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

void read_diameters(const Table& table, std::vector<Filled>& filled) {
  const auto each = read_one_each(table, "diameters", filled.size());
  if (!each.empty() && table.has("diameter"))
    table.at("diameters").refuse("both diameter and diameters", "one of the two");
  const double all = each.empty() ? table.at("diameter").positive() : 0.0;
  for (std::size_t i = 0; i < filled.size(); ++i)
    filled[i].diameter = each.empty() ? all : each[i].positive();
}

std::vector<Filled> read_explicit(const Table& table, Group& group, const Particle& common, bool rotation) {
  table.only({"material", "diameter", "diameters", "effect_diameter", "fixed", "positions", "velocities",
              "angular_velocities", "ids"});
  group.positions = table.at("positions").at_least_one();
  std::vector<Filled> filled;
  for (const Node& position : group.positions)
    filled.push_back({position.vector(), {}, {}, Vec3::Zero(), {}});
  const auto velocities = read_one_each(table, "velocities", group.positions.size());
  group.ids = read_one_each(table, "ids", group.positions.size());
  for (std::size_t i = 0; i < filled.size(); ++i) {
    if (!velocities.empty()) filled[i].velocity = velocities[i].vector();
    if (!group.ids.empty()) filled[i].id = group.ids[i].integer_within(1, largest_id);
    if (filled[i].velocity && !filled[i].velocity->isZero(0.0)) refuse_motion(common, velocities[i]);
  }
  read_diameters(table, filled);
  read_spins(table, common, rotation, filled);
  return filled;
}

std::vector<Filled> read_fill_from_file(const Table& table, const Table& fill, const Reading& reading,
                                        std::size_t largest) {
  std::vector<Filled> filled = fill_from_file(fill, reading.folder, largest);
  if (filled.front().diameter) {
    if (table.has("diameter")) table.at("diameter").refuse("no diameter, since the file has its own");
    return filled;
  }
  Diameters diameters(table.at("diameter"));
  for (Filled& particle : filled) particle.diameter = diameters.next();
  return filled;
}

std::vector<Filled> read_fill(const Table& table, const Reading& reading, const Scene& scene) {
  const std::size_t there = std::min(scene.particles.size(), reading.options.most_particles);
  const std::size_t largest = reading.options.most_particles - there;
  const Table fill = table.at("fill").table();
  const FillKind kind = fill.at("kind").choice(fill_kinds);
  if (kind == FillKind::file) return read_fill_from_file(table, fill, reading, largest);
  Diameters diameters(table.at("diameter"));
  if (kind == FillKind::lattice) return fill_lattice(fill, diameters, largest);
  return fill_random(fill, diameters, scene, largest);
}

void check_spins(const Table& table, const Particle& common, bool rotation,
                 const std::vector<Filled>& filled) {
  for (const Filled& particle : filled) {
    if (particle.angular_velocity.isZero(0.0)) continue;
    if (!rotation)
      table.at("fill").refuse("spins in a scene without rotation", "rotation = true in [bodies]");
    refuse_motion(common, table.at("fill"));
  }
}

/// `velocity` is added to all; `random_speed` and `random_spin` bound what each component gets besides.
void set_in_motion(const Table& table, const Particle& common, bool rotation, std::vector<Filled>& filled) {
  const auto velocity = table.find("velocity");
  const auto speed = table.find("random_speed");
  if (velocity) refuse_motion(common, *velocity);
  const auto spin = table.find("random_spin");
  if (speed) refuse_motion(common, *speed);
  if (spin) refuse_motion(common, *spin);
  if (spin && !rotation)
    spin->refuse("random_spin in a scene without rotation", "rotation = true in [bodies]");
  if (!speed && !spin && table.has("seed"))
    table.at("seed").refuse("no seed without random_speed or random_spin");
  const Vec3 mean = velocity ? velocity->vector() : Vec3::Zero();
  const double amplitude = speed ? speed->not_negative() : 0.0;
  const double most_spin = spin ? spin->not_negative() : 0.0;
  Uniform uniform(speed || spin ? table.at("seed").seed() : 0);
  for (Filled& particle : filled) {
    if (particle.velocity && !particle.velocity->isZero(0.0)) refuse_motion(common, table.at("fill"));
    particle.velocity = particle.velocity.value_or(Vec3::Zero()) + mean;
    if (speed) *particle.velocity += amplitude * uniform.in_cube();
  }
  if (spin)
    for (Filled& particle : filled) particle.angular_velocity += most_spin * uniform.in_cube();
}

/// Where a particle's diameter is written.
Node place_of_diameter(const Table& table, std::size_t particle) {
  if (const auto each = table.find("diameters")) return each->elements()[particle];
  return table.has("diameter") ? table.at("diameter") : table.at("fill");
}

void set_size(const Table& table, std::size_t at, double diameter, double density, Particle& particle) {
  particle.diameter = diameter;
  check_mass(place_of_diameter(table, at), density, diameter);
  if (particle.effect_diameter == 0.0) particle.effect_diameter = diameter;
  if (particle.effect_diameter < diameter)
    table.at("effect_diameter").refuse("at least the body's diameter, " + shortest(diameter));
}

void append(const Table& table, const std::vector<Filled>& filled, const Particle& common, Scene& scene) {
  std::int64_t next = 1;
  for (const Particle& particle : scene.particles) next = std::max(next, particle.id + 1);
  const double density = scene.materials[common.material].density;
  for (std::size_t i = 0; i < filled.size(); ++i) {
    const Filled& one = filled[i];
    Particle particle = common;
    set_size(table, i, one.diameter.value(), density, particle);
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
    table.only({"material", "diameter", "effect_diameter", "fixed", "fill", "velocity", "random_speed",
                "random_spin", "seed"});
  Group group{set_up.scene.particles.size(), {}, {}, table.at("material")};
  const Particle common = read_common(table, set_up.scene);
  std::vector<Filled> filled;
  if (fill) {
    group.positions = {*fill};
    filled = read_fill(table, reading, set_up.scene);
    check_spins(table, common, set_up.scene.rotation, filled);
    set_in_motion(table, common, set_up.scene.rotation, filled);
  } else {
    filled = read_explicit(table, group, common, set_up.scene.rotation);
  }
  append(table, filled, common, set_up.scene);
  set_up.groups.push_back(std::move(group));
}

}  // namespace

void read_particles(const std::vector<Node>& tables, const Reading& reading, SetUp& set_up) {
  for (const Node& node : tables) read_group(node.table(), reading, set_up);
}

}  // namespace grainproof::input
