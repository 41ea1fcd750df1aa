// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

enum class FrictionKind { none, step, collision_time, damped };

constexpr std::pair<std::string_view, FrictionKind> friction_laws[] = {
    {"none", FrictionKind::none},
    {"step", FrictionKind::step},
    {"collision_time", FrictionKind::collision_time},
    {"damped", FrictionKind::damped}};

enum class OnlyLinear { linear };
constexpr std::pair<std::string_view, OnlyLinear> linear_laws[] = {{"linear", OnlyLinear::linear}};

Dissipation read_dissipation(const Table& table, bool no_tension) {
  const auto restitution = table.find("restitution");
  const auto damping = table.find("damping");
  if (restitution && damping) damping->refuse("either restitution or damping, not both");
  if (damping) return Damping{damping->not_negative()};
  const Node given = table.at("restitution");
  const double value = given.number_within(0.0, 1.0);
  if (no_tension && value == 0.0)
    given.refuse("more than 0, since a contact that never pulls always rebounds (or give damping)");
  return Restitution{value};
}

NormalLaw read_normal(const Table& table) {
  table.at("law").choice(linear_laws);
  table.only({"law", "stiffness", "restitution", "damping", "no_tension"});
  const bool no_tension = table.boolean("no_tension", false);
  return LinearNormal{table.at("stiffness").positive(), read_dissipation(table, no_tension), no_tension};
}

FrictionLaw read_friction(const Table& table) {
  const FrictionKind kind = table.at("law").choice(friction_laws);
  if (kind == FrictionKind::none) {
    table.only({"law", "coefficient"});
    return DynamicFriction{table.at("coefficient").not_negative()};
  }
  table.only({"law", "coefficient", "stiffness"});
  const double coefficient = table.at("coefficient").not_negative();
  const double stiffness = table.at("stiffness").positive();
  if (kind == FrictionKind::step) return StepFriction{coefficient, stiffness};
  if (kind == FrictionKind::collision_time) return CollisionTimeFriction{coefficient, stiffness};
  return DampedFriction{coefficient, stiffness};
}

CohesionLaw read_cohesion(const Table& table) {
  table.at("law").choice(linear_laws);
  table.only({"law", "stiffness"});
  return LinearCohesion{table.at("stiffness").positive()};
}

void read_contact(const Table& table, Scene& scene) {
  table.only({"between", "normal", "friction", "cohesion"});
  const Node between = table.at("between");
  const auto names = between.elements();
  if (names.size() != 2) between.refuse("the names of two materials");
  const auto a = static_cast<std::size_t>(read_material_name(names[0], scene));
  const auto b = static_cast<std::size_t>(read_material_name(names[1], scene));
  if (scene.contacts.has(a, b)) between.refuse("between = " + between.label() + " again", "each pair once");
  ContactLaws laws{read_normal(table.at("normal").table()), {}, {}};
  if (const auto friction = table.find("friction")) laws.friction = read_friction(friction->table());
  if (const auto cohesion = table.find("cohesion")) laws.cohesion = read_cohesion(cohesion->table());
  scene.contacts.set(a, b, laws);
}

}  // namespace

void read_contacts(const std::vector<Node>& tables, Scene& scene) {
  for (const Node& node : tables) read_contact(node.table(), scene);
}

}  // namespace grainproof::input
