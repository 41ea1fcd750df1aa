// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/stability_map.hpp"

#include <sstream>

namespace grainproof::bench {
namespace {

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

using Cases = std::vector<StabilityCase>;

void add_cases(Cases& cases, const std::string& arrangement, const std::vector<std::string>& restitutions,
               const std::vector<std::pair<double, double>>& ratios,
               const std::vector<std::string>& frictions) {
  for (const std::string& friction : frictions)
    for (const auto& [masses, stiffnesses] : ratios)
      for (const std::string& restitution : restitutions)
        cases.push_back({arrangement, restitution, masses, stiffnesses, friction});
}

const std::vector<std::string> both{"none", "history"};

Cases quick_cases() {
  Cases cases;
  add_cases(cases, "pair", {"none", "0.8", "overdamped"}, {{1, 1}, {1e6, 1}}, both);
  add_cases(cases, "pair", {"0.8"}, {{1, 1}}, {"step", "damped"});
  add_cases(cases, "wall", {"0.8"}, {{1, 1}}, {"none"});
  add_cases(cases, "chain", {"0.1"}, {{1e3, 100}}, {"none"});
  add_cases(cases, "face_centred", {"0.1"}, {{1, 1}}, both);
  add_cases(cases, "random_8", {"0.1"}, {{1, 1}}, {"none"});
  return cases;
}

/// Friction without memory is a drag at rest, as long as it is far below the Coulomb limit.
void add_forgetful(Cases& cases) {
  const std::vector<std::string> variants{"step", "collision_time", "damped"};
  add_cases(cases, "pair", {"none", "0.8", "0.1"}, {{1, 1}, {1e3, 1}}, variants);
  add_cases(cases, "wall", {"0.8", "0.1"}, {{1, 1}}, variants);
  add_cases(cases, "chain", {"0.8"}, {{1, 1}, {1e3, 100}}, variants);
  for (const char* arrangement : {"face_centred", "random_10"})
    add_cases(cases, arrangement, {"0.8"}, {{1, 1}}, variants);
}

Cases all_cases() {
  const std::vector<std::string> all{"none", "1", "0.95", "0.8", "0.5", "0.1", "0", "overdamped"};
  const std::vector<std::string> some{"none", "0.8", "0.1", "overdamped"};
  const std::vector<std::pair<double, double>> mixtures{{1, 1}, {1e3, 1}, {1, 100}, {1e6, 100}};
  Cases cases;
  add_cases(cases, "pair", all, {{1, 1}, {10, 1}, {100, 1}, {1e3, 1}, {1e4, 1}, {1e5, 1}, {1e6, 1}},
            {"none"});
  add_cases(cases, "pair", all, {{1, 1}, {1e3, 1}, {1e6, 1}}, {"history"});
  add_cases(cases, "wall", all, {{1, 1}}, both);
  add_cases(cases, "wall", some, {{1, 10}, {1, 1e3}}, both);
  for (const char* arrangement : {"chain", "simple_cubic", "face_centred"})
    add_cases(cases, arrangement, some, mixtures, both);
  for (const char* arrangement : {"random_8", "random_10", "random_12"})
    add_cases(cases, arrangement, some, {{1, 1}, {1e3, 1}, {1, 10}}, {"none"});
  add_cases(cases, "random_10", {"none", "0.8"}, {{1, 1}}, {"history"});
  add_forgetful(cases);
  return cases;
}

}  // namespace

std::vector<StabilityCase> stability_map(bool quick) {
  return quick ? quick_cases() : all_cases();
}

bool is_representative(const StabilityCase& one, bool quick) {
  if (quick) return one.arrangement == "pair" && one.mass_ratio == 1.0 && one.restitution != "overdamped";
  if (one.arrangement == "simple_cubic")  // as many bodies as the path of small scenes takes
    return one.restitution == "0.8" && one.mass_ratio == 1.0 && one.stiffness_ratio == 1.0;
  return (one.restitution == "none" || one.restitution == "0.8" || one.restitution == "0.1") &&
         (one.mass_ratio == 1.0 || one.mass_ratio == 1e6) &&
         (one.stiffness_ratio == 1.0 || one.mass_ratio == 1e6);
}

double weight_of(const StabilityCase& one, const std::string& engine) {
  const bool turns = one.friction != "none";
  double weight = 1.0;  // a pair, a sphere on a wall, a chain
  if (one.arrangement == "face_centred") weight = turns ? 30.0 : 4.0;
  if (one.arrangement == "simple_cubic") weight = turns ? 40.0 : 10.0;
  if (one.arrangement.starts_with("random")) weight = turns ? 200.0 : 40.0;
  return engine == "reference" ? weight : weight + 20.0;  // kernels are compiled
}

std::string name_of(const StabilityCase& one, const std::string& engine, const std::string& integrator) {
  return "scene:" + one.arrangement + "/" + engine + "/integrator:" + integrator +
         "/restitution:" + one.restitution + "/mass_ratio:" + number(one.mass_ratio) +
         "/stiffness_ratio:" + number(one.stiffness_ratio) + "/friction:" + one.friction;
}

}  // namespace grainproof::bench
