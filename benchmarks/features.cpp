// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <memory>

#include "benchmarks/common/scenes.hpp"
#include "benchmarks/common/subject.hpp"

namespace grainproof::bench {
namespace {

/// Changes a scene into what a feature is measured on.
using Change = void (*)(Scene& scene);

/// A feature and what it is held against: two scenes that differ in it alone.
struct Feature {
  const char* name;
  const char* scene;
  Change without;
  Change with;
  bool ledger = false;  ///< the feature is the ledger
};

ContactLaws laws_with(FrictionLaw law) {
  ContactLaws laws = usual_laws();
  laws.friction = law;
  return laws;
}

void nothing(Scene&) {}

void slippery(Scene& scene) {
  scene.contacts.set(0, 0, laws_with(Frictionless{}));
  scene.rotation = false;
}

void viscous_friction(Scene& scene) {
  scene.contacts.set(0, 0, laws_with(CollisionTimeFriction{friction, stiffness}));
  scene.rotation = false;
}

void no_rotation(Scene& scene) {
  scene.rotation = false;
}

void with_orientation(Scene& scene) {
  scene.orientation = OrientationUpdate::exponential;
}

void constant_torque(Scene& scene) {
  ContactLaws laws = usual_laws();
  laws.rolling = ConstantTorqueRolling{0.01};
  scene.contacts.set(0, 0, laws);
}

void rolling_spring(Scene& scene) {
  ContactLaws laws = usual_laws();
  laws.rolling = SpringRolling{0.01};
  scene.contacts.set(0, 0, laws);
}

/// As stiff as the linear contact at the overlaps of the bed.
void hertz(Scene& scene) {
  scene.materials[0].elasticity = Elasticity{1.8e8, 0.3};
  ContactLaws laws = usual_laws();
  laws.normal = HertzNormal{Restitution{restitution}};
  scene.contacts.set(0, 0, laws);
}

void cohesion(Scene& scene) {
  ContactLaws laws = usual_laws();
  laws.cohesion = LinearCohesion{1e-3 * stiffness};
  scene.contacts.set(0, 0, laws);
  for (Particle& particle : scene.particles) particle.effect_diameter = 1.02 * diameter;
}

/// The same physics, nearly, but no radius is the other's.
void many_sizes(Scene& scene) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double smaller = diameter * (1.0 - 1e-9 * static_cast<double>(i % 1000));
    scene.particles[i].diameter = scene.particles[i].effect_diameter = smaller;
  }
}

void two_materials(Scene& scene) {
  scene.materials.push_back({"other", density});
  scene.contacts = ContactTable(2);
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = a; b < 2; ++b) scene.contacts.set(a, b, usual_laws());
  for (std::size_t i = 0; i < scene.particles.size(); i += 2) scene.particles[i].material = 1;
}

void canonical(Scene& scene) {
  scene.run.order = SumOrder::canonical;
}

void drag(Scene& scene) {
  scene.flow = UniformFlow{1.8e-5, Vec3(1.0, 0.0, 0.0)};
}

/// Into the void, which is far enough for a short while.
void open_box(Scene& scene) {
  const Vec3 margin = 0.2 * scene.domain.extent();
  scene.domain.lower -= margin;
  scene.domain.upper += margin;
  scene.domain.boundary = {Boundary::open, Boundary::open, Boundary::open};
}

/// Open as well, so that what differs is six planes; the outermost particles start out of touch.
void walled_box(Scene& scene) {
  const double gap = diameter;
  const Vec3 lower = scene.domain.lower.array() - gap, upper = scene.domain.upper.array() + gap;
  open_box(scene);
  for (int axis = 0; axis < 3; ++axis) {
    scene.walls.push_back({"lower", 0, Plane{lower, Vec3::Unit(axis)}});
    scene.walls.push_back({"upper", 0, Plane{upper, -Vec3::Unit(axis)}});
  }
}

constexpr std::array features{
    Feature{"friction without history", "bed", slippery, viscous_friction},
    Feature{"history", "bed", viscous_friction, no_rotation},
    Feature{"rotation", "bed", no_rotation, nothing},
    Feature{"orientation", "bed", nothing, with_orientation},
    Feature{"rolling, constant torque", "bed", nothing, constant_torque},
    Feature{"rolling, spring", "bed", nothing, rolling_spring},
    Feature{"Hertz for linear", "bed", nothing, hertz},
    Feature{"cohesion", "bed", nothing, cohesion},
    Feature{"sizes that differ", "bed", nothing, many_sizes},
    Feature{"two materials", "bed", nothing, two_materials},
    Feature{"ledger", "bed", nothing, nothing, true},
    Feature{"canonical order", "bed", nothing, canonical},
    Feature{"friction and history", "gas", slippery, nothing},
    Feature{"periodic faces", "gas", open_box, nothing},
    Feature{"six walls", "gas", open_box, walled_box},
    Feature{"drag", "gas", nothing, drag},
    Feature{"ledger", "gas", nothing, nothing, true},
};

std::shared_ptr<Subject> subject(const Settings& settings, const std::string& engine, std::int64_t particles,
                                 const Feature& feature, bool with) {
  const Change change = with ? feature.with : feature.without;
  const auto make = [&settings, scene = std::string(feature.scene), change](std::int64_t size) {
    Scene made = scene_named(scene, size, settings.cache);
    change(made);
    return made;
  };
  Request request;
  request.ledger = feature.ledger && with;
  return std::make_shared<Subject>(engine, make, particles, settings, request);
}

void add_feature(const Settings& settings, const std::string& engine, std::int64_t particles,
                 const Feature& feature) {
  const std::array both{subject(settings, engine, particles, feature, false),
                        subject(settings, engine, particles, feature, true)};
  for (int round = 0; round < settings.rounds; ++round)
    for (std::size_t with = 0; with < 2; ++with)
      add_measurement("features/scene:" + sized_name(feature.scene, particles) + "/" + engine_key(engine) +
                          "/feature:" + feature.name + "/with:" + (with ? "yes" : "no") +
                          "/round:" + std::to_string(round),
                      both[with]);
}

void add(const Settings& settings) {
  for (const std::string& engine : settings.engines)
    for (const Feature& feature : features) add_feature(settings, engine, settings.particles.at(0), feature);
}

}  // namespace
}  // namespace grainproof::bench

int main(int argc, char** argv) {
  return grainproof::bench::run_benchmarks(argc, argv, grainproof::bench::add);
}
