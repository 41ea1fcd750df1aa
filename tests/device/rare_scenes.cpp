// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "rare_scenes.hpp"

#include <map>

#include "varied_scenes.hpp"

namespace grainproof::opencl::testing {
namespace {

struct Rare {
  const char* like;
  void (*change)(Scene& scene);
  bool small_only = false;
};

void predict(Scene& scene) {
  scene.run.integrator = Integrator::velocity_verlet_predicted;
}

void correct(Scene& scene) {
  scene.run.integrator = Integrator::onset_corrected;
}

/// Friction bends where the limit is on spring and dashpot.
void correct_bends(Scene& scene) {
  correct(scene);
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = HistoryFriction{0.1, 8e4, 0.5};
  scene.contacts.set(0, 0, laws);
}

void foresee(Scene& scene) {
  scene.run.integrator = Integrator::velocity_verlet_implicit;
}

void compose(Scene& scene) {
  scene.run.integrator = Integrator::pefrl;
}

void orient(Scene& scene) {
  scene.orientation = OrientationUpdate::forward_euler;
}

void orient_exactly(Scene& scene) {
  scene.orientation = OrientationUpdate::exponential;
}

void roll_on_springs(Scene& scene) {
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.rolling = SpringRolling{0.1};
  scene.contacts.set(0, 0, laws);
}

const std::map<std::string, Rare>& rare() {
  static const std::map<std::string, Rare> table{
      {"predicted", {"damped_friction", predict}},
      {"predicted_turning", {"turning_liggghts", predict}},
      {"onset", {"damped_friction", correct}},
      {"onset_turning", {"turning_liggghts", correct}},
      {"onset_bending", {"turning_liggghts", correct_bends}},
      {"predicted_hertz", {"hertz", predict}},
      {"onset_hertz", {"hertz", correct}},
      {"implicit", {"damped_friction", foresee}},
      {"implicit_turning", {"turning_liggghts", foresee}},
      {"implicit_in_vortices", {"vortices", foresee}},
      {"composed", {"damped_friction", compose, true}},
      {"oriented", {"turning_damped", orient}},
      {"oriented_exactly", {"turning_damped", orient_exactly}},
      {"rolling_on_springs", {"turning_liggghts", roll_on_springs}},
  };
  return table;
}

}  // namespace

std::vector<std::string> rare_scene_names(bool small_only) {
  std::vector<std::string> names;
  for (const auto& [name, what] : rare())
    if (what.small_only == small_only) names.push_back(name);
  return names;
}

Scene any_scene(const std::string& name, int layers) {
  const auto found = rare().find(name);
  if (found == rare().end()) return varied_scene(name, layers);
  Scene scene = varied_scene(found->second.like, layers);
  found->second.change(scene);
  return scene;
}

}  // namespace grainproof::opencl::testing
