// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/external/scene_json.hpp"

#include <string>
#include <variant>

namespace grainproof::external {
namespace {

using nlohmann::json;

json vector(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

json run(const Scene& scene, const Request& request) {
  const std::vector<std::int64_t> steps = sample_steps(scene, request);
  json times = json::array();
  for (const std::int64_t step : steps) times.push_back(static_cast<double>(step) * scene.run.step);
  return {{"end", scene.run.end},
          {"step", scene.run.step},
          {"steps", step_at_or_after(scene.run.end, scene.run.step)},
          {"integrator", std::string(name_of(scene.run.integrator))},
          {"overlap_limit", scene.run.overlap_limit},
          {"frame_steps", steps},
          {"frame_times", times}};
}

json domain(const Domain& box) {
  json boundary = json::array();
  for (const Boundary face : box.boundary)
    boundary.push_back(face == Boundary::open ? "open" : face == Boundary::periodic ? "periodic" : "wall");
  return {{"lower", vector(box.lower)}, {"upper", vector(box.upper)}, {"boundary", boundary}};
}

json with_dissipation(json law, const Dissipation& dissipation) {
  std::visit(Overloaded{[&](const Restitution& given) { law["restitution"] = given.value; },
                        [&](const Damping& given) { law["damping"] = given.value; },
                        [&](const DampingRatio& given) { law["damping_ratio"] = given.value; }},
             dissipation);
  return law;
}

json normal(const NormalLaw& law) {
  return std::visit(Overloaded{[](const LinearNormal& linear) {
                                 return with_dissipation({{"law", "linear"},
                                                          {"stiffness", linear.stiffness},
                                                          {"no_tension", linear.no_tension}},
                                                         linear.dissipation);
                               },
                               [](const HertzNormal& hertz) {
                                 return with_dissipation({{"law", "hertz"}}, hertz.dissipation);
                               }},
                    law);
}

json history(const HistoryFriction& law) {
  return {{"law", "history"},
          {"coefficient", law.coefficient},
          {"stiffness", law.stiffness},
          {"damping_ratio", law.damping_ratio},
          {"limit", law.limit == CoulombLimit::spring ? "spring" : "spring_and_dashpot"},
          {"arm", law.arm == TorqueArm::radius ? "radius" : "overlap"},
          {"turn", law.turn == SpringTurn::project ? "project" : "project_and_rescale"},
          {"memory", law.memory == SpringMemory::displacement ? "displacement" : "force"}};
}

json friction(const FrictionLaw& law) {
  const auto with_spring = [](const char* name, const auto& given) {
    return json{{"law", name}, {"coefficient", given.coefficient}, {"stiffness", given.stiffness}};
  };
  return std::visit(
      Overloaded{[](const Frictionless&) { return json(nullptr); },
                 [](const DynamicFriction& given) {
                   return json{{"law", "none"}, {"coefficient", given.coefficient}};
                 },
                 [&](const StepFriction& given) { return with_spring("step", given); },
                 [&](const CollisionTimeFriction& given) { return with_spring("collision_time", given); },
                 [&](const DampedFriction& given) { return with_spring("damped", given); },
                 [](const HistoryFriction& given) { return history(given); }},
      law);
}

json cohesion(const CohesionLaw& law) {
  return std::visit(Overloaded{[](const NoCohesion&) { return json(nullptr); },
                               [](const LinearCohesion& given) {
                                 return json{{"law", "linear"}, {"stiffness", given.stiffness}};
                               }},
                    law);
}

json rolling(const RollingLaw& law) {
  return std::visit(Overloaded{[](const NoRolling&) { return json(nullptr); },
                               [](const ConstantTorqueRolling& given) {
                                 return json{{"law", "constant_torque"}, {"coefficient", given.coefficient}};
                               },
                               [](const SpringRolling& given) {
                                 return json{{"law", "spring"}, {"coefficient", given.coefficient}};
                               }},
                    law);
}

json contacts(const ContactTable& table) {
  json out = json::array();
  for (std::size_t a = 0; a < table.materials(); ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      if (!table.has(a, b)) continue;
      const ContactLaws& laws = table.at(a, b);
      out.push_back({{"between", {b, a}},
                     {"normal", normal(laws.normal)},
                     {"friction", friction(laws.friction)},
                     {"cohesion", cohesion(laws.cohesion)},
                     {"rolling", rolling(laws.rolling)}});
    }
  return out;
}

json materials(const std::vector<Material>& all) {
  json out = json::array();
  for (const Material& material : all) {
    json& entry = out.emplace_back(json{{"name", material.name}, {"density", material.density}});
    if (!material.elasticity) continue;
    entry["youngs_modulus"] = material.elasticity->youngs_modulus;
    entry["poisson_ratio"] = material.elasticity->poisson_ratio;
  }
  return out;
}

json particles(const std::vector<Particle>& all) {
  json out = json::array();
  for (const Particle& p : all)
    out.push_back({{"id", p.id},
                   {"material", p.material},
                   {"fixed", p.fixed},
                   {"diameter", p.diameter},
                   {"effect_diameter", p.effect_diameter},
                   {"position", vector(p.position)},
                   {"velocity", vector(p.velocity)},
                   {"angular_velocity", vector(p.angular_velocity)}});
  return out;
}

json motion(const WallMotion& how) {
  return std::visit(Overloaded{[](const Still&) { return json(nullptr); },
                               [](const Translating& given) {
                                 return json{{"velocity", vector(given.velocity)}};
                               },
                               [](const Rotating& given) {
                                 return json{{"rate", given.rate}};
                               },
                               [](const Vibrating& given) {
                                 return json{{"amplitude", vector(given.amplitude)},
                                             {"frequency", given.frequency},
                                             {"phase", given.phase}};
                               }},
                    how);
}

json walls(const std::vector<Wall>& all) {
  json out = json::array();
  for (const Wall& wall : all) {
    json& entry = out.emplace_back(
        json{{"name", wall.name}, {"material", wall.material}, {"motion", motion(wall.motion)}});
    std::visit(
        Overloaded{[&](const Plane& plane) {
                     entry["plane"] = {{"point", vector(plane.point)}, {"normal", vector(plane.normal)}};
                   },
                   [&](const Cylinder& round) {
                     entry["cylinder"] = {
                         {"point", vector(round.point)},
                         {"axis", vector(round.axis)},
                         {"radius", round.radius},
                         {"side", round.side == Cylinder::Side::inside ? "inside" : "outside"}};
                   },
                   [&](const Rectangle& flat) {
                     entry["rectangle"] = {{"lower", vector(flat.lower)}, {"upper", vector(flat.upper)}};
                   }},
        wall.shape);
  }
  return out;
}

json gravity(const Gravity& field) {
  return std::visit(
      Overloaded{
          [](const ConstantGravity& g) {
            return json{{"kind", "constant"}, {"acceleration", vector(g.acceleration)}};
          },
          [](const RotatingGravity& g) {
            return json{{"kind", "rotating"}, {"magnitude", g.magnitude}, {"time_scale", g.time_scale}};
          },
          [](const CentralGravity& g) {
            return json{{"kind", "central"}, {"magnitude", g.magnitude}, {"centre", vector(g.centre)}};
          }},
      field);
}

json flow(const Flow& field) {
  return std::visit(
      Overloaded{
          [](const NoFlow&) { return json(nullptr); },
          [](const UniformFlow& f) {
            return json{{"kind", "uniform"}, {"viscosity", f.viscosity}, {"velocity", vector(f.velocity)}};
          },
          [](const TaylorGreenFlow& f) {
            return json{{"kind", "taylor_green"},
                        {"viscosity", f.viscosity},
                        {"amplitude", f.amplitude},
                        {"wave_number", f.wave_number}};
          }},
      field);
}

}  // namespace

json scene_json(const Scene& scene, const Request& request) {
  return {{"schema", 1},
          {"title", scene.title},
          {"run", run(scene, request)},
          {"domain", domain(scene.domain)},
          {"rotation", scene.rotation},
          {"materials", materials(scene.materials)},
          {"contacts", contacts(scene.contacts)},
          {"particles", particles(scene.particles)},
          {"walls", walls(scene.walls)},
          {"gravity", gravity(scene.gravity)},
          {"flow", flow(scene.flow)}};
}

}  // namespace grainproof::external
