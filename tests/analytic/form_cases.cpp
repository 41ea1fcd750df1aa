// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/analytic/form_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "analytic/contact_scales.hpp"
#include "tests/analytic/scenes.hpp"

namespace grainproof::analytic {
namespace {

const Vec3 slanted = Vec3(2.0, -3.0, 6.0) / 7.0;
const Vec3 aside = Vec3(6.0, -2.0, -3.0) / 7.0;  // at right angles to `slanted`
const Vec3 offset(1.0, -0.5, 0.25);

void sample(Scene& scene, double end, int samples = 24) {
  scene.run.end = end;
  scene.run.sample_times.clear();
  for (int n = 0; n <= samples; ++n) scene.run.sample_times.push_back(end * n / samples);
}

/// The quicker of the contact's vibration and its dashpot.
double fastest(const Scene& scene) {
  const ContactScale contact = shortest_contact(scene).value();
  return std::min(contact.duration, std::numbers::pi * contact.effective_mass / contact.damping);
}

/// Positions of about 1 m carry 1e-16 each and so does the gap; a contact turns an error of the gap into
/// 1/time_scale times as much speed, some 1e-13; a few roundings on top.
FormCase contact_case(std::string label, std::string form, Scene scene, double end = 0.03) {
  sample(scene, end);
  const double scale = fastest(scene);
  return {std::move(label), form, form, std::move(scene), scale, 2.0, 4e-15, 1e-12};
}

Scene pair(const LinearNormal& normal, bool fixed, double gap = 1e-4) {
  Scene scene = glass_scene(normal);
  add_sphere(scene, offset, fixed ? Vec3::Zero() : Vec3(0.3 * slanted), fixed, 0.1);
  const double d = fixed ? 0.1 : 0.06;
  add_sphere(scene, offset + (0.5 * (0.1 + d) + gap) * slanted, -2.0 * slanted, false, d);
  return scene;
}

Scene on_wall(const LinearNormal& normal, const Vec3& wall_normal, double gap, const Vec3& velocity) {
  Scene scene = glass_scene(normal);
  scene.walls.push_back({"floor", 0, Plane{offset, wall_normal}});
  add_sphere(scene, offset + (0.05 + gap) * wall_normal, velocity);
  return scene;
}

Scene with_friction(Scene scene, const FrictionLaw& friction) {
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.friction = friction;
  scene.contacts.set(0, 0, laws);
  return scene;
}

Scene with_cohesion(Scene scene, double stiffness, double effect_over_body) {
  ContactLaws laws = scene.contacts.at(0, 0);
  laws.cohesion = LinearCohesion{stiffness};
  scene.contacts.set(0, 0, laws);
  for (Particle& particle : scene.particles) particle.effect_diameter = effect_over_body * particle.diameter;
  return scene;
}

Scene with_gravity(Scene scene, const Vec3& gravity) {
  scene.gravity = ConstantGravity{gravity};
  return scene;
}

void add_flights(std::vector<FormCase>& cases) {
  Scene drag = glass_scene();
  drag.materials[0].density = 10.0;
  drag.flow = UniformFlow{1.93e-3, Vec3::UnitX()};
  add_sphere(drag, Vec3::Zero(), Vec3::Zero());
  sample(drag, 14.4);
  // Positions run to 12 m and 400 m: 1e-16 of that, a few times.
  cases.push_back({"Drag", "drag", "drag", drag, 2.9, 1.0, 1e-14, 2e-15});
  const Scene falling = with_gravity(drag, {0.0, -9.81, 0.0});
  cases.push_back({"DragAndGravity", "drag", "drag", falling, 2.9, 28.0, 4e-13, 4e-14});
  Scene fall = with_gravity(glass_scene(), {1.0, 2.0, -9.81});
  add_sphere(fall, offset, Vec3(0.0, 0.0, 3.0));
  sample(fall, 2.0);
  cases.push_back({"FreeFall", "free_fall", "free_fall", fall, 1.0, 10.0, 1e-14, 1e-14});
}

void add_collisions(std::vector<FormCase>& cases) {
  const double m = sphere_mass(2000.0, 0.1), critical = 2.0 * std::sqrt(m * 1e5);
  const std::pair<const char*, LinearNormal> laws[] = {
      {"UnderDamped", {1e5, Restitution{0.8}}},
      {"Elastic", {1e5, Restitution{1.0}}},
      {"CriticallyDamped", {1e5, Damping{critical}}},
      {"OverDamped", {1e5, Damping{3.0 * critical}}},
      {"NoTension", {1e5, Restitution{0.8}, true}},
      {"OverDampedNoTension", {1e5, Damping{3.0 * critical}, true}},
      {"NearlyPlasticNoTension", {1e5, Restitution{0.1}, true}},
  };
  for (const auto& [label, law] : laws) {
    const std::string name(label);
    cases.push_back(contact_case(name + "OnFixedSphere", "normal_collision", pair(law, true)));
    cases.push_back(contact_case(name + "UnequalFreeSpheres", "normal_collision", pair(law, false)));
    cases.push_back(
        contact_case(name + "OnWall", "normal_collision", on_wall(law, slanted, 1e-4, -2.0 * slanted)));
  }
  cases.push_back(contact_case("FrictionlessObliqueOnWall", "normal_collision",
                               on_wall({1e5, Restitution{0.8}}, slanted, 1e-4, aside - 2.0 * slanted)));
}

void add_rests(std::vector<FormCase>& cases) {
  const Vec3 down = -9.81 * slanted;
  for (const bool clamped : {false, true}) {
    const std::string end = clamped ? "NoTension" : "";
    const LinearNormal law{1e5, Restitution{0.5}, clamped};
    cases.push_back(contact_case("Settling" + end, "settling",
                                 with_gravity(on_wall(law, slanted, -1e-5, Vec3::Zero()), down), 0.1));
    cases.push_back(contact_case("Bounce" + end, "bounce",
                                 with_gravity(on_wall(law, slanted, 2e-3, Vec3::Zero()), down), 0.15));
    cases.back().speed_scale = 0.2;
  }
  cases.push_back(contact_case(
      "BounceDownAFrictionlessIncline", "bounce",
      with_gravity(on_wall({1e5, Restitution{0.5}}, slanted, 2e-3, 0.5 * aside), down + 3.0 * aside), 0.1));
}

void add_slides(std::vector<FormCase>& cases) {
  const double rest = sphere_mass(2000.0, 0.1) * 9.81 / 1e5;
  Scene scene = with_gravity(on_wall({1e5, Restitution{0.8}}, slanted, -rest, aside), -9.81 * slanted);
  scene.run.step = 1e-3;
  const std::pair<const char*, FrictionLaw> laws[] = {
      {"DynamicSliding", DynamicFriction{0.6}},
      {"StepSliding", StepFriction{0.6, 1e5}},
      {"CollisionTimeSliding", CollisionTimeFriction{0.6, 1e5}},
      {"DampedSliding", DampedFriction{0.6, 1e5}},
  };
  for (const auto& [label, law] : laws) {
    cases.push_back(contact_case(label, "sliding", with_friction(scene, law), 0.16));
    cases.back().speed_scale = 1.0;
    cases.back().time_scale = 1e-3;  // m/(k_f t_c)
  }
}

void add_obliques(std::vector<FormCase>& cases) {
  for (const bool clamped : {false, true}) {
    const std::string end = clamped ? "NoTension" : "";
    const LinearNormal law{1e5, Restitution{0.8}, clamped};
    const Scene scene = on_wall(law, slanted, 1e-4, 3.0 * aside - 1.0 * slanted);
    cases.push_back(contact_case("ObliqueDynamic" + end, "oblique_collision",
                                 with_friction(scene, DynamicFriction{0.3})));
    cases.push_back(contact_case("ObliqueCollisionTime" + end, "oblique_collision",
                                 with_friction(scene, CollisionTimeFriction{0.3, 1e5})));
  }
}

void add_cohesives(std::vector<FormCase>& cases) {
  for (const double speed_down : {2.0, 0.4}) {
    const std::string end = speed_down > 1.0 ? "Rebounding" : "Sticking";
    Scene fixed = with_cohesion(pair({1e5, Restitution{0.8}}, true, 0.02), 1e3, 1.2);
    fixed.particles[1].velocity = -speed_down * slanted;
    cases.push_back(contact_case("Cohesive" + end, "cohesive_collision", fixed, 0.1));
    Scene free = with_cohesion(pair({1e5, Restitution{0.8}}, false, 0.02), 1e3, 1.2);
    free.particles[1].velocity = -speed_down * slanted;
    cases.push_back(contact_case("Cohesive" + end + "UnequalFreeSpheres", "cohesive_collision", free, 0.1));
    Scene clamped = with_cohesion(
        on_wall({1e5, Restitution{0.5}, true}, slanted, 0.012, -speed_down * slanted), 1e3, 1.2);
    cases.push_back(contact_case("Cohesive" + end + "OnWallNoTension", "cohesive_collision", clamped, 0.1));
  }
}

}  // namespace

std::vector<FormCase> form_cases() {
  std::vector<FormCase> cases;
  add_flights(cases);
  add_collisions(cases);
  add_rests(cases);
  add_slides(cases);
  add_obliques(cases);
  add_cohesives(cases);
  return cases;
}

}  // namespace grainproof::analytic
