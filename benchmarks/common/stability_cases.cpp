// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/stability_cases.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "analytic/contact_scales.hpp"
#include "benchmarks/common/made_once.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

constexpr double sphere = 0.1;       // m
constexpr double light = 2000.0;     // kg/m³
constexpr double stiffness = 1e5;    // N/m: the source's own
constexpr double overlap = 1e-4;     // of a diameter
constexpr double attraction = 1e-3;  // of a contact's stiffness: what keeps free bodies in touch
constexpr double reach = 1.0 + overlap * (1.0 - attraction) / attraction;  // of a diameter
constexpr double coefficient = 0.5;
constexpr double tangential = 2.0 / 7.0;
constexpr double tangential_dashpot = 0.5;

Dissipation dissipation_of(const std::string& restitution) {
  if (restitution == "none") return Damping{0.0};
  if (restitution == "overdamped") return DampingRatio{2.0};
  return Restitution{std::stod(restitution)};
}

FrictionLaw friction_of(const std::string& variant, double k) {
  if (variant == "none") return Frictionless{};
  if (variant == "history") return HistoryFriction{coefficient, tangential * k, tangential_dashpot};
  if (variant == "step") return StepFriction{coefficient, tangential * k};
  if (variant == "collision_time") return CollisionTimeFriction{coefficient, tangential * k};
  if (variant == "damped") return DampedFriction{coefficient, tangential * k};
  throw InputRefused("found friction " + variant + "; expected one of docs/stability.md");
}

ContactLaws laws_of(const StabilityCase& of, double k, bool cohesion) {
  ContactLaws laws{LinearNormal{k, dissipation_of(of.restitution)}};
  laws.friction = friction_of(of.friction, k);
  if (cohesion) laws.cohesion = LinearCohesion{attraction * k};
  return laws;
}

/// Material 0 is light and soft, 1 heavy and stiff; a contact of both has the mean of their stiffness.
Scene empty_scene_of(const StabilityCase& of, const Vec3& box, bool cohesion) {
  Scene scene;
  scene.title = of.arrangement;
  scene.run.end = 1.0;
  scene.run.sample_times = {0.0, 1.0};
  scene.domain = {Vec3::Zero(), box};
  scene.rotation = of.friction != "none";
  scene.materials = {{"light", light}, {"heavy", light * of.mass_ratio}};
  scene.contacts = ContactTable(2);
  scene.contacts.set(0, 0, laws_of(of, stiffness, cohesion));
  scene.contacts.set(0, 1, laws_of(of, stiffness * std::sqrt(of.stiffness_ratio), cohesion));
  scene.contacts.set(1, 1, laws_of(of, stiffness * of.stiffness_ratio, cohesion));
  return scene;
}

void add_sphere(Scene& scene, int material, const Vec3& position, double effect = reach * sphere) {
  const auto id = static_cast<std::int64_t>(scene.particles.size()) + 1;
  scene.particles.push_back({id, material, false, sphere, effect, position, Vec3::Zero()});
}

/// One light, one heavy. Attraction balances the spring, so that no force turns with the pair.
Scene pair(const StabilityCase& of) {
  Scene scene = empty_scene_of(of, Vec3::Constant(3.0 * sphere), true);
  const Vec3 half = 0.5 * sphere * (1.0 - overlap) * Vec3::UnitX();
  add_sphere(scene, 0, Vec3::Constant(1.5 * sphere) - half);
  add_sphere(scene, 1, Vec3::Constant(1.5 * sphere) + half);
  return scene;
}

/// Under its weight; between a floor and a stiffer lid where there is a ratio.
Scene wall(const StabilityCase& of) {
  Scene scene = empty_scene_of(of, Vec3::Constant(3.0 * sphere), false);
  scene.walls.push_back({"floor", 0, Plane{Vec3::Zero(), Vec3::UnitZ()}});
  const double height = 0.5 * sphere * (1.0 - 2.0 * overlap);
  add_sphere(scene, 0, Vec3(1.5 * sphere, 1.5 * sphere, height), sphere);
  if (of.stiffness_ratio > 1.0) {
    const double lid = height + 0.5 * sphere - overlap * sphere / std::sqrt(of.stiffness_ratio);
    scene.walls.push_back({"lid", 1, Plane{lid * Vec3::UnitZ(), -Vec3::UnitZ()}});
  } else {
    const double mass = light * std::numbers::pi / 6.0 * std::pow(sphere, 3);
    scene.gravity = ConstantGravity{-stiffness * overlap * sphere / mass * Vec3::UnitZ()};
  }
  return scene;
}

/// Eight in a periodic line, two light ones and two heavy ones in turn.
Scene chain(const StabilityCase& of) {
  const double spacing = sphere * (1.0 - overlap);
  Scene scene = empty_scene_of(of, Vec3(8.0 * spacing, 4.0 * sphere, 4.0 * sphere), true);
  scene.domain.boundary[0] = Boundary::periodic;
  for (int i = 0; i < 8; ++i)
    add_sphere(scene, i / 2 % 2, Vec3((i + 0.5) * spacing, 2.0 * sphere, 2.0 * sphere));
  return scene;
}

/// Four layers in a periodic box, light and heavy in turn, of the sites with i + j + l even or of all.
Scene lattice(const StabilityCase& of, bool face_centred) {
  const double spacing = sphere * (1.0 - overlap) * (face_centred ? std::numbers::sqrt2 / 2.0 : 1.0);
  Scene scene = empty_scene_of(of, Vec3::Constant(4.0 * spacing), true);
  scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
  for (int l = 0; l < 4; ++l)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i)
        if (!face_centred || (i + j + l) % 2 == 0)
          add_sphere(scene, l % 2, spacing * Vec3(i + 0.5, j + 0.5, l + 0.5));
  return scene;
}

/// A minimum of the elastic energy knows of stiffnesses alone, and takes long to be found: once for all
/// dampings, masses and frictions.
const Scene& packed(const StabilityCase& of) {
  static MadeOnce<std::pair<std::string, double>, Scene> known;
  return known.get({of.arrangement, of.stiffness_ratio}, [&] {
    Scene scene =
        empty_scene_of({of.arrangement, "none", 1.0, of.stiffness_ratio}, Vec3::Constant(sphere), false);
    scene.domain.boundary = {Boundary::periodic, Boundary::periodic, Boundary::periodic};
    fill_packing(scene, std::stoi(of.arrangement.substr(7)));
    return scene;
  });
}

Scene random_packing(const StabilityCase& of) {
  const Scene& places = packed(of);
  Scene scene = empty_scene_of(of, Vec3::Constant(sphere), false);
  scene.domain = places.domain;
  scene.particles = places.particles;
  return scene;
}

}  // namespace

Scene resting_scene(const StabilityCase& of) {
  if (of.arrangement == "pair") return pair(of);
  if (of.arrangement == "wall") return wall(of);
  if (of.arrangement == "chain") return chain(of);
  if (of.arrangement == "simple_cubic") return lattice(of, false);
  if (of.arrangement == "face_centred") return lattice(of, true);
  if (of.arrangement.starts_with("random_")) return random_packing(of);
  throw InputRefused("found arrangement " + of.arrangement + "; expected one of docs/stability.md");
}

Vec3 apart(const Scene& scene, std::size_t one, std::size_t other) {
  Vec3 between = scene.particles[other].position - scene.particles[one].position;
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis))
      between[axis] -= scene.domain.extent()[axis] * std::round(between[axis] / scene.domain.extent()[axis]);
  return between;
}

double least_slack(const Scene& scene) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double radius = 0.5 * scene.particles[i].diameter;
    for (const Wall& wall : scene.walls) {
      const auto& plane = std::get<Plane>(wall.shape);
      const double height = (scene.particles[i].position - plane.point).dot(plane.normal);
      least = std::min(least, std::abs(radius - height));
    }
    for (std::size_t j = 0; j < i; ++j)
      least =
          std::min(least, std::abs(radius + 0.5 * scene.particles[j].diameter - apart(scene, i, j).norm()));
  }
  return least;
}

int most_contacts(const Scene& scene) {
  std::vector<int> contacts(scene.particles.size(), static_cast<int>(scene.walls.size()));
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (apart(scene, i, j).norm() < 0.5 * (scene.particles[i].diameter + scene.particles[j].diameter)) {
        ++contacts[i];
        ++contacts[j];
      }
  return *std::ranges::max_element(contacts);
}

double contact_time_of(const Scene& scene) {
  return analytic::shortest_contact(scene)->duration;
}

}  // namespace grainproof::bench
