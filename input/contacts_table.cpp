// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

enum class FrictionKind { none, step, collision_time, damped, history };

constexpr std::pair<std::string_view, FrictionKind> friction_laws[] = {
    {"none", FrictionKind::none},
    {"step", FrictionKind::step},
    {"collision_time", FrictionKind::collision_time},
    {"damped", FrictionKind::damped},
    {"history", FrictionKind::history}};

constexpr std::pair<std::string_view, CoulombLimit> limits[] = {
    {"spring", CoulombLimit::spring}, {"spring_and_dashpot", CoulombLimit::spring_and_dashpot}};
constexpr std::pair<std::string_view, TorqueArm> arms[] = {{"radius", TorqueArm::radius},
                                                           {"overlap", TorqueArm::overlap}};
constexpr std::pair<std::string_view, SpringTurn> turns[] = {
    {"project", SpringTurn::project}, {"project_and_rescale", SpringTurn::project_and_rescale}};

constexpr std::pair<std::string_view, SpringMemory> memories[] = {
    {"displacement", SpringMemory::displacement}, {"force", SpringMemory::force}};

enum class RollingKind { constant_torque, spring };
constexpr std::pair<std::string_view, RollingKind> rolling_laws[] = {
    {"constant_torque", RollingKind::constant_torque}, {"spring", RollingKind::spring}};

enum class NormalKind { linear, hertz };
constexpr std::pair<std::string_view, NormalKind> normal_laws[] = {{"linear", NormalKind::linear},
                                                                   {"hertz", NormalKind::hertz}};

enum class OnlyLinear { linear };
constexpr std::pair<std::string_view, OnlyLinear> linear_laws[] = {{"linear", OnlyLinear::linear}};

/// Refuses a second way of saying what the dashpot is.
void check_one_dashpot(const Table& table) {
  std::optional<Node> first;
  for (const std::string_view key : {"restitution", "damping", "damping_ratio"}) {
    const auto node = table.find(key);
    if (first && node)
      node->refuse("either " + std::string(first->name()) + " or " + std::string(key) + ", not both");
    if (node) first = node;
  }
}

Dissipation read_dissipation(const Table& table, bool no_tension) {
  check_one_dashpot(table);
  if (const auto damping = table.find("damping")) return Damping{damping->not_negative()};
  if (const auto ratio = table.find("damping_ratio")) return DampingRatio{ratio->not_negative()};
  const Node given = table.at("restitution");
  const double value = given.number_within(0.0, 1.0);
  if (no_tension && value == 0.0)
    given.refuse("more than 0, since a contact that never pulls always rebounds (or give damping)");
  return Restitution{value};
}

/// `between`: the two materials, each of which must say how it deforms.
HertzNormal read_hertz(const Table& table, std::initializer_list<const Material*> between) {
  table.only({"law", "restitution", "damping_ratio"});
  for (const Material* material : between)
    if (!material->elasticity)
      table.at("law").refuse(
          "law = \"hertz\" with material " + material->name + ", whose elasticity is not given",
          "youngs_modulus and poisson_ratio of " + material->name);
  check_one_dashpot(table);
  if (const auto ratio = table.find("damping_ratio")) return {DampingRatio{ratio->not_negative()}};
  const Node given = table.at("restitution");
  const double value = given.number_within(0.0, 1.0);
  if (value == 0.0) given.refuse("more than 0, since such a contact would never end");
  return {Restitution{value}};
}

NormalLaw read_normal(const Table& table, std::initializer_list<const Material*> between) {
  if (table.at("law").choice(normal_laws) == NormalKind::hertz) return read_hertz(table, between);
  table.only({"law", "stiffness", "restitution", "damping", "damping_ratio", "no_tension"});
  const bool no_tension = table.boolean("no_tension", false);
  return LinearNormal{table.at("stiffness").positive(), read_dissipation(table, no_tension), no_tension};
}

double read_tangential_stiffness(const Table& table, bool hertz) {
  const auto stiffness = table.find("stiffness");
  if (hertz && stiffness) stiffness->refuse("no stiffness, since that of a Hertz contact is Mindlin's");
  return hertz ? 0.0 : table.at("stiffness").positive();
}

HistoryFriction read_history(const Table& table, bool hertz) {
  table.only({"law", "coefficient", "stiffness", "damping_ratio", "limit", "arm", "turn", "memory"});
  const auto ratio = table.find("damping_ratio");
  HistoryFriction friction{table.at("coefficient").not_negative(), read_tangential_stiffness(table, hertz),
                           ratio ? ratio->not_negative() : 0.0};
  if (const auto limit = table.find("limit")) friction.limit = limit->choice(limits);
  if (const auto arm = table.find("arm")) friction.arm = arm->choice(arms);
  if (const auto turn = table.find("turn")) friction.turn = turn->choice(turns);
  if (const auto memory = table.find("memory")) friction.memory = memory->choice(memories);
  return friction;
}

FrictionLaw read_friction(const Table& table, bool hertz) {
  const FrictionKind kind = table.at("law").choice(friction_laws);
  if (kind == FrictionKind::history) return read_history(table, hertz);
  if (kind == FrictionKind::none) {
    table.only({"law", "coefficient"});
    return DynamicFriction{table.at("coefficient").not_negative()};
  }
  if (hertz && kind != FrictionKind::step)
    table.at("law").refuse(
        "\"none\", \"step\" or \"history\", since a Hertz contact has no stiffness k of its own");
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

RollingLaw read_rolling(const Table& table, const FrictionLaw& friction, bool rotation) {
  const Node law = table.at("law");
  const RollingKind kind = law.choice(rolling_laws);
  table.only({"law", "coefficient"});
  if (!rotation) table.whole().refuse("rolling in a scene without rotation", "rotation = true in [bodies]");
  const double coefficient = table.at("coefficient").not_negative();
  if (kind == RollingKind::constant_torque) return ConstantTorqueRolling{coefficient};
  if (!std::holds_alternative<HistoryFriction>(friction))
    law.refuse("rolling on a spring without friction that has one", "friction = { law = \"history\", … }");
  return SpringRolling{coefficient};
}

void read_contact(const Table& table, Scene& scene) {
  table.only({"between", "normal", "friction", "cohesion", "rolling"});
  const Node between = table.at("between");
  const auto names = between.elements();
  if (names.size() != 2) between.refuse("the names of two materials");
  const auto a = static_cast<std::size_t>(read_material_name(names[0], scene));
  const auto b = static_cast<std::size_t>(read_material_name(names[1], scene));
  if (scene.contacts.has(a, b)) between.refuse("between = " + between.label() + " again", "each pair once");
  ContactLaws laws{
      read_normal(table.at("normal").table(), {&scene.materials[a], &scene.materials[b]}), {}, {}, {}};
  const bool hertz = std::holds_alternative<HertzNormal>(laws.normal);
  if (const auto friction = table.find("friction")) laws.friction = read_friction(friction->table(), hertz);
  if (const auto cohesion = table.find("cohesion")) laws.cohesion = read_cohesion(cohesion->table());
  if (const auto rolling = table.find("rolling"))
    laws.rolling = read_rolling(rolling->table(), laws.friction, scene.rotation);
  scene.contacts.set(a, b, laws);
}

}  // namespace

void read_contacts(const std::vector<Node>& tables, Scene& scene) {
  for (const Node& node : tables) read_contact(node.table(), scene);
}

}  // namespace grainproof::input
