// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/liggghts/deck.hpp"

#include <algorithm>
#include <sstream>

#include "comparisons/liggghts/models.hpp"
#include "comparisons/liggghts/walls.hpp"
#include "comparisons/peers/atom_types.hpp"
#include "comparisons/peers/deck.hpp"

namespace grainproof::liggghts {
namespace {

using peers::AtomType;
using peers::PairParameters;
using peers::TypeTable;

/// A property of pairs of types; `value` takes both.
template <class Value>
std::string of_pairs(const char* name, const TypeTable& table, const Value& value) {
  std::ostringstream out = peers::exact_text();
  out << "fix " << name << " all property/global " << name << " peratomtypepair " << table.types.size();
  for (const AtomType& a : table.types)
    for (const AtomType& b : table.types) out << ' ' << value(a, b);
  out << '\n';
  return out.str();
}

std::string model(const Models& models) {
  return std::string("model ") + (models.hertz ? "hertz" : "hooke/stiffness") + " tangential " +
         (models.history ? "history" : "no_history") +
         (models.rolling == Rolling::off   ? ""
          : models.rolling == Rolling::cdt ? " rolling_friction cdt"
                                           : " rolling_friction epsd2");
}

std::string model_settings(const Models& models) {
  const char* damping =
      models.hertz ? (models.tangential_damping ? " tangential_damping on" : " tangential_damping off")
                   : " absolute_damping on tangential_damping on";
  return std::string(damping) + " limitForce " + (models.no_tension ? "on" : "off");
}

/// no_history never uses kt, but hooke/stiffness wants it.
std::string linear_properties(const Scene& scene, const TypeTable& table) {
  const auto property = [&](const char* name, double PairParameters::*member) {
    return of_pairs(name, table, [&](const AtomType& a, const AtomType& b) {
      return peers::pair_parameters(scene, a, b).*member;
    });
  };
  return property("kn", &PairParameters::stiffness) + property("kt", &PairParameters::tangential_stiffness) +
         property("gamman_abs", &PairParameters::damping) +
         property("gammat_abs", &PairParameters::tangential_damping) +
         property("coefficientFriction", &PairParameters::friction);
}

std::string of_materials(const char* name, const Scene& scene, const TypeTable& table, double other,
                         double Elasticity::*member) {
  std::ostringstream out = peers::exact_text();
  out << "fix " << name << " all property/global " << name << " peratomtype";
  for (const AtomType& type : table.types) {
    const auto& elasticity = scene.materials[static_cast<std::size_t>(type.material)].elasticity;
    out << ' ' << (elasticity ? (*elasticity).*member : other);
  }
  out << '\n';
  return out.str();
}

double restitution_between(const Scene& scene, const AtomType& a, const AtomType& b) {
  const ContactLaws* laws = peers::laws_between(scene, a, b);
  return laws ? restitution_of(std::get<HertzNormal>(laws->normal).dissipation) : 1.0;
}

double friction_between(const Scene& scene, const AtomType& a, const AtomType& b) {
  const ContactLaws* laws = peers::laws_between(scene, a, b);
  const auto* history = laws ? std::get_if<HistoryFriction>(&laws->friction) : nullptr;
  return history ? history->coefficient : 0.0;
}

/// A material without moduli is in no contact; any that LIGGGHTS takes will do for it.
std::string hertz_properties(const Scene& scene, const TypeTable& table) {
  return of_materials("youngsModulus", scene, table, 1e7, &Elasticity::youngs_modulus) +
         of_materials("poissonsRatio", scene, table, 0.3, &Elasticity::poisson_ratio) +
         of_pairs("coefficientRestitution", table,
                  [&](const AtomType& a, const AtomType& b) { return restitution_between(scene, a, b); }) +
         of_pairs("coefficientFriction", table,
                  [&](const AtomType& a, const AtomType& b) { return friction_between(scene, a, b); });
}

double rolling_between(const Scene& scene, const AtomType& a, const AtomType& b) {
  const ContactLaws* laws = peers::laws_between(scene, a, b);
  return laws ? std::visit(Overloaded{[](const NoRolling&) { return 0.0; },
                                      [](const auto& rolling) { return rolling.coefficient; }},
                           laws->rolling)
              : 0.0;
}

std::string rolling_property(const Scene& scene, const TypeTable& table, const Models& models) {
  if (models.rolling == Rolling::off) return {};
  return of_pairs("coefficientRollingFriction", table,
                  [&](const AtomType& a, const AtomType& b) { return rolling_between(scene, a, b); });
}

std::string contacts(const Scene& scene, const TypeTable& table, const Models& models) {
  return "pair_style gran " + model(models) + model_settings(models) + "\npair_coeff * *\n" +
         (models.hertz ? hertz_properties(scene, table) : linear_properties(scene, table)) +
         rolling_property(scene, table, models);
}

bool any_mesh(const Scene& scene) {
  return std::any_of(scene.walls.begin(), scene.walls.end(),
                     [&](const Wall& wall) { return is_mesh(scene, wall); });
}

constexpr double worth_forgetting = 5e6;  // particle-steps

/// A pair that parts and touches again keeps its old spring until a new list of neighbours drops it
/// (measured), so where that is cheap there is one at every step.
std::string forgetting(const Scene& scene, const Models& models) {
  const double work = static_cast<double>(scene.particles.size()) * scene.run.end / scene.run.step;
  return models.history && work <= worth_forgetting ? "neigh_modify every 1 delay 0 check no\n" : "";
}

}  // namespace

std::string scene_deck(const Scene& scene, const Request& request, const std::filesystem::path& folder,
                       int number) {
  const TypeTable table = peers::atom_types(scene);
  const Models models = models_of(scene);
  peers::write_inputs(scene, request, table, folder, number);
  return "clear\nsoft_particles yes\nhard_particles yes\natom_style granular\n" +
         peers::set_up(scene, "communicate single vel yes", any_mesh(scene), number) +
         forgetting(scene, models) + contacts(scene, table, models) +
         wall_commands(scene, table.of_wall, {model(models), model_settings(models)}, folder, number) +
         peers::motion(scene, table) + peers::fields(scene, table) +
         peers::output_and_run(scene, request, "format", number);
}

}  // namespace grainproof::liggghts
