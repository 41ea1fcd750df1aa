// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/set_up.hpp"

namespace grainproof::input {
namespace {

enum class GravityKind { rotating, central };
constexpr std::pair<std::string_view, GravityKind> gravity_kinds[] = {{"rotating", GravityKind::rotating},
                                                                      {"central", GravityKind::central}};

enum class FlowKind { still, uniform, taylor_green };
constexpr std::pair<std::string_view, FlowKind> flow_kinds[] = {
    {"still", FlowKind::still}, {"uniform", FlowKind::uniform}, {"taylor_green", FlowKind::taylor_green}};

/// The source's box turns by θ = t²/4 = (t/2 s)².
constexpr double source_time_scale = 2.0;

Gravity read_gravity(const Node& node) {
  if (node.is_array()) return ConstantGravity{node.vector()};
  if (!node.is_table()) node.refuse("three numbers in m/s², or a table with a kind");
  const Table table = node.table();
  if (table.at("kind").choice(gravity_kinds) == GravityKind::central) {
    table.only({"kind", "magnitude", "centre"});
    return CentralGravity{table.at("magnitude").not_negative(), table.at("centre").vector()};
  }
  table.only({"kind", "magnitude", "time_scale"});
  const auto time_scale = table.find("time_scale");
  return RotatingGravity{table.at("magnitude").not_negative(),
                         time_scale ? time_scale->positive() : source_time_scale};
}

Flow read_flow(const Table& table) {
  const FlowKind kind = table.at("kind").choice(flow_kinds);
  const double viscosity = table.at("viscosity").positive();
  if (kind == FlowKind::still) {
    table.only({"kind", "viscosity"});
    return UniformFlow{viscosity, Vec3::Zero()};
  }
  if (kind == FlowKind::uniform) {
    table.only({"kind", "viscosity", "velocity"});
    return UniformFlow{viscosity, table.at("velocity").vector()};
  }
  table.only({"kind", "viscosity", "amplitude", "wave_number"});
  return TaylorGreenFlow{viscosity, table.at("amplitude").number(), table.at("wave_number").positive()};
}

}  // namespace

void read_field(const Table& table, Scene& scene) {
  table.only({"gravity", "flow"});
  if (const auto gravity = table.find("gravity")) scene.gravity = read_gravity(*gravity);
  if (const auto flow = table.find("flow")) scene.flow = read_flow(flow->table());
}

}  // namespace grainproof::input
