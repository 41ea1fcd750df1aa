// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "reference_cpu/contact_force.hpp"
#include "tests/reference/scenes.hpp"

namespace grainproof::testing {
namespace {

/// As stiff as no material is: E* is then the other body's E/(1 − ν²) to the last digit.
constexpr Elasticity rigid{1e30, 0.0};

/// Material 0 is the sphere's, material 1 a rigid wall's.
Scene hertz_scene(const Material& material, double restitution, const FrictionLaw& friction, double step) {
  Scene scene = empty_scene({}, step);
  scene.materials = {material, {"rigid", 1.0, rigid}};
  scene.contacts = ContactTable(2);
  const ContactLaws laws{.normal = HertzNormal{Restitution{restitution}}, .friction = friction};
  scene.contacts.set(0, 0, laws);
  scene.contacts.set(0, 1, laws);
  return scene;
}

void add_rigid_floor(Scene& scene) {
  scene.walls.push_back({"floor", 1, Plane{Vec3::Zero(), Vec3::UnitZ()}});
}

/// Largest overlap and force, and how long they touch.
struct Impact {
  double overlap, force, duration;
};

/// δ_max = (15 m v²/(16 E* sqrt(R*)))^(2/5), t_c = 2.943275 δ_max/v.
Impact closed_form(double modulus, double radius, double mass, double speed) {
  const double overlap = std::pow(15.0 * mass * speed * speed / (16.0 * modulus * std::sqrt(radius)), 0.4);
  return {overlap, 4.0 / 3.0 * modulus * std::sqrt(radius) * std::pow(overlap, 1.5),
          2.943275 * overlap / speed};
}

/// What a scene of bodies that begin to touch shows; `distance` is that of the surfaces.
template <class Distance>
Impact observed(const Scene& scene, Distance distance) {
  const auto run = start(scene);
  Impact found{0.0, 0.0, 0.0};
  double overlap = 0.0, before = 0.0;
  Vec3 velocity = scene.particles[0].velocity;
  const double mass = sphere_mass(scene.particles[0].diameter, scene.materials[0].density);
  do {
    run->advance(1);
    const Frame frame = run->frame();
    before = overlap;
    overlap = -distance(frame);
    found.overlap = std::max(found.overlap, overlap);
    found.force = std::max(found.force, mass * (frame.velocity[0] - velocity).norm() / scene.run.step);
    velocity = frame.velocity[0];
    found.duration = frame.time;
  } while (overlap > 0.0);
  found.duration += scene.run.step * overlap / (before - overlap);
  return found;
}

void expect_near(const Impact& found, const Impact& expected, double relative) {
  EXPECT_NEAR(found.overlap, expected.overlap, relative * expected.overlap);
  EXPECT_NEAR(found.force, expected.force, relative * expected.force);
  EXPECT_NEAR(found.duration, expected.duration, relative * expected.duration);
}

/// Two equal spheres at ±v, elastic.
Impact head_on(const Material& material, double radius, double speed, double steps_per_contact) {
  const double poisson = material.elasticity->poisson_ratio;
  const double modulus = 0.5 * material.elasticity->youngs_modulus / (1.0 - poisson * poisson);
  const double mass = 0.5 * sphere_mass(2.0 * radius, material.density);
  const Impact expected = closed_form(modulus, 0.5 * radius, mass, 2.0 * speed);
  Scene scene = hertz_scene(material, 1.0, Frictionless{}, expected.duration / steps_per_contact);
  add_particle(scene, 2.0 * radius, {-radius, 0.0, 0.0}, {speed, 0.0, 0.0});
  add_particle(scene, 2.0 * radius, {radius, 0.0, 0.0}, {-speed, 0.0, 0.0});
  return observed(scene, [radius](const Frame& frame) {
    return (frame.position[1] - frame.position[0]).norm() - 2.0 * radius;
  });
}

/// A sphere on a rigid floor, elastic.
Impact on_floor(const Material& material, double radius, double speed, double steps_per_contact) {
  const double poisson = material.elasticity->poisson_ratio;
  const double modulus = material.elasticity->youngs_modulus / (1.0 - poisson * poisson);
  const double mass = sphere_mass(2.0 * radius, material.density);
  const Impact expected = closed_form(modulus, radius, mass, speed);
  Scene scene = hertz_scene(material, 1.0, Frictionless{}, expected.duration / steps_per_contact);
  add_rigid_floor(scene);
  add_particle(scene, 2.0 * radius, {0.0, 0.0, radius}, {0.0, 0.0, -speed});
  return observed(scene, [radius](const Frame& frame) { return frame.position[0].z() - radius; });
}

const Material glass{"glass", 2800.0, Elasticity{48e9, 0.20}};
const Material limestone{"limestone", 2500.0, Elasticity{20e9, 0.25}};
const Material aluminium{"aluminium alloy", 2699.0, Elasticity{70e9, 0.30}};
const Material magnesium{"magnesium alloy", 1800.0, Elasticity{40e9, 0.35}};

// Chung and Ooi 2011, case 1: overlap, force and duration as published to four or five figures.
TEST(Hertz, PairsCollideAsChungAndOoiPublished) {
  expect_near(head_on(glass, 0.01, 10.0, 200.0), {274.11e-6, 10696.9, 40.34e-6}, 5e-4);
  expect_near(head_on(limestone, 0.01, 10.0, 200.0), {368.30e-6, 7108.2, 54.20e-6}, 5e-4);
}

// Case 2.
TEST(Hertz, SpheresBounceOffARigidFloorAsChungAndOoiPublished) {
  expect_near(on_floor(aluminium, 0.1, 0.2, 200.0), {49.717e-6, 11369.9, 731.66e-6}, 5e-4);
  expect_near(on_floor(magnesium, 0.1, 0.2, 200.0), {52.123e-6, 7232.7, 767.07e-6}, 5e-4);
}

/// Relative errors of an impact with so many steps a contact.
Impact error_with(double steps_per_contact) {
  const Impact exact = closed_form(70e9 / (1.0 - 0.09), 0.1, sphere_mass(0.2, 2699.0), 0.2);
  const Impact found = on_floor(aluminium, 0.1, 0.2, steps_per_contact);
  return {std::abs(found.overlap / exact.overlap - 1.0), std::abs(found.force / exact.force - 1.0),
          std::abs(found.duration / exact.duration - 1.0)};
}

// Velocity Verlet is of second order, and so is what peaks lose that are seen at step ends only.
TEST(Hertz, ImpactComesToTheClosedFormInSecondOrder) {
  const Impact coarse = error_with(50.0), fine = error_with(200.0);
  EXPECT_NEAR(0.5 * std::log2(coarse.overlap / fine.overlap), 2.0, 0.1);
  EXPECT_NEAR(0.5 * std::log2(coarse.duration / fine.duration), 2.0, 0.1);
  EXPECT_LE(fine.duration, 2e-5);
}

double rebound(const Material& material, double restitution, double steps_per_contact) {
  const double radius = 2.5e-3, speed = 3.9;
  const double poisson = material.elasticity->poisson_ratio;
  const double modulus = material.elasticity->youngs_modulus / (1.0 - poisson * poisson);
  const Impact scale = closed_form(modulus, radius, sphere_mass(2.0 * radius, material.density), speed);
  Scene scene = hertz_scene(material, restitution, Frictionless{}, scale.duration / steps_per_contact);
  add_rigid_floor(scene);
  add_particle(scene, 2.0 * radius, {0.0, 0.0, radius}, {0.0, 0.0, -speed});
  const auto run = start(scene);
  do run->advance(1);
  while (run->frame().position[0].z() < radius);
  run->advance(1);
  return run->frame().velocity[0].z() / speed;
}

// Chung and Ooi case 3. Tsuji's damping rebounds with the restitution asked for, up to the onset's error.
TEST(Hertz, DampedSphereReboundsWithItsRestitution) {
  for (const double restitution : {0.2, 0.4, 0.6, 0.8, 1.0})
    for (const Material& material : {Material{"alumina", 4000.0, Elasticity{380e9, 0.23}},
                                     Material{"cast iron", 7000.0, Elasticity{100e9, 0.25}}})
      EXPECT_NEAR(rebound(material, restitution, 4000.0), restitution, 3e-4 * restitution) << material.name;
}

// ν = 0.25, E = 1.5e9 on both sides: E* = 0.8e9, G* = E/(4 (2 − ν)(1 + ν)) = 1.5e9/8.75. R* 0.04 and
// δ 1e-4 make a contact circle of 2e-3.
reference::PairLaws hand_laws(CoulombLimit limit) {
  const Material material{"rubber", 1000.0, Elasticity{1.5e9, 0.25}};
  return reference::resolve(hertz_scene(material, 0.5, HistoryFriction{0.5, 0.0, 1.0, limit}, 1e-5), 0, 0);
}

TEST(Hertz, ForceAndMindlinsSpringAreAsEvaluatedByHand) {
  reference::ContactSprings springs{.displacement = {0.0, 1e-6, 0.0}};
  const reference::ContactPoint point{Vec3::UnitX(), 1e-4, Vec3::Zero(), 0.01, 0.04};
  const auto force = contact_force(hand_laws(CoulombLimit::spring), point, 0.0, springs);
  EXPECT_NEAR(force.normal, 4.0 / 3.0 * 0.8e9 * 2e-3 * 1e-4, 1e-12 * force.normal);
  const double shear_stiffness = 8.0 * (1.5e9 / 8.75) * 2e-3;
  EXPECT_NEAR(force.friction.y(), -shear_stiffness * 1e-6, 1e-12 * shear_stiffness * 1e-6);
}

// β' = ln 2/sqrt(ln² 2 + π²); dashpots 2 β' sqrt(5/6) sqrt(m k) with k 2 E* a and 8 G* a.
TEST(Hertz, DashpotsAreTsujis) {
  const double share = std::log(2.0) / std::hypot(std::log(2.0), std::numbers::pi);
  const double per_root = 2.0 * share * std::sqrt(5.0 / 6.0);
  reference::ContactSprings springs;
  const reference::ContactPoint still{Vec3::UnitX(), 1e-4, Vec3::Zero(), 0.01, 0.04};
  const reference::ContactPoint moving{Vec3::UnitX(), 1e-4, {-0.3, 0.2, 0.0}, 0.01, 0.04};
  const auto laws = hand_laws(CoulombLimit::spring_and_dashpot);
  const double push = contact_force(laws, still, 0.0, springs).normal;
  const auto force = contact_force(laws, moving, 0.0, springs);
  const double eta = per_root * std::sqrt(0.01 * 2.0 * 0.8e9 * 2e-3);
  const double shear_eta = per_root * std::sqrt(0.01 * 8.0 * (1.5e9 / 8.75) * 2e-3);
  EXPECT_NEAR(force.normal - push, 0.3 * eta, 1e-12 * push);
  EXPECT_NEAR(force.friction.y(), -0.2 * shear_eta, 1e-12 * push);
}

// Bilock 4.4 and 4.6: 2 γ sqrt(m k) with k 2 E* a and, halved by the friction's own ratio, 8 G* a.
TEST(Hertz, DampingRatioIsAShareOfTheStiffnessesOfTheMoment) {
  Scene scene = empty_scene({}, 1e-5);
  scene.materials[0].elasticity = Elasticity{1.5e9, 0.25};
  scene.contacts.set(0, 0,
                     {.normal = HertzNormal{DampingRatio{0.2}}, .friction = HistoryFriction{0.5, 0.0, 0.5}});
  const auto laws = reference::resolve(scene, 0, 0);
  reference::ContactSprings springs;
  const reference::ContactPoint moving{Vec3::UnitX(), 1e-4, {-0.3, 0.2, 0.0}, 0.01, 0.04};
  const auto force = contact_force(laws, moving, 0.0, springs);
  const double push = 4.0 / 3.0 * 0.8e9 * 2e-3 * 1e-4;
  EXPECT_NEAR(force.normal - push, 0.3 * 0.4 * std::sqrt(0.01 * 2.0 * 0.8e9 * 2e-3), 1e-12 * push);
  EXPECT_NEAR(force.friction.y(), -0.2 * 0.2 * std::sqrt(0.01 * 8.0 * (1.5e9 / 8.75) * 2e-3), 1e-12 * push);
}

}  // namespace
}  // namespace grainproof::testing
