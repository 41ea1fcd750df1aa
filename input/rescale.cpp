// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "input/transforms.hpp"

namespace grainproof::input {
namespace {

// Density, moduli and velocities stay: masses go with s³, times with s, forces with s², stiffnesses with s.

Domain scaled(Domain domain, double s) {
  domain.lower *= s;
  domain.upper *= s;
  return domain;
}

void scale(Particle& particle, double s) {
  particle.diameter *= s;
  particle.effect_diameter *= s;
  particle.position *= s;
  particle.angular_velocity /= s;
}

void scale(Wall& wall, double s) {
  std::visit(Overloaded{[&](Plane& plane) { plane.point *= s; },
                        [&](Cylinder& cylinder) {
                          cylinder.point *= s;
                          cylinder.radius *= s;
                        },
                        [&](Rectangle& rectangle) {
                          rectangle.lower *= s;
                          rectangle.upper *= s;
                        }},
             wall.shape);
  std::visit(Overloaded{[](Still&) {}, [](Translating&) {}, [&](Rotating& turning) { turning.rate /= s; },
                        [&](Vibrating& shaking) {
                          shaking.amplitude *= s;
                          shaking.frequency /= s;
                        }},
             wall.motion);
}

void scale(NormalLaw& law, double s) {
  auto* linear = std::get_if<LinearNormal>(&law);
  if (linear == nullptr) return;
  linear->stiffness *= s;
  if (auto* damping = std::get_if<Damping>(&linear->dissipation)) damping->value *= s * s;
}

void scale(FrictionLaw& law, double s) {
  std::visit(Overloaded{[](Frictionless&) {}, [](DynamicFriction&) {},
                        [&](auto& friction) { friction.stiffness *= s; }},
             law);
}

ContactTable scaled(const ContactTable& contacts, double s) {
  ContactTable out(contacts.materials());
  for (std::size_t a = 0; a < contacts.materials(); ++a)
    for (std::size_t b = a; b < contacts.materials(); ++b) {
      if (!contacts.has(a, b)) continue;
      ContactLaws laws = contacts.at(a, b);
      scale(laws.normal, s);
      scale(laws.friction, s);
      if (auto* cohesion = std::get_if<LinearCohesion>(&laws.cohesion)) cohesion->stiffness *= s;
      out.set(a, b, std::move(laws));
    }
  return out;
}

void scale(Gravity& gravity, double s) {
  std::visit(Overloaded{[&](ConstantGravity& constant) { constant.acceleration /= s; },
                        [&](RotatingGravity& rotating) {
                          rotating.magnitude /= s;
                          rotating.time_scale *= s;
                        },
                        [&](CentralGravity& central) {
                          central.magnitude /= s;
                          central.centre *= s;
                        }},
             gravity);
}

void scale(Flow& flow, double s) {
  if (auto* uniform = std::get_if<UniformFlow>(&flow)) uniform->viscosity *= s;
  if (auto* vortices = std::get_if<TaylorGreenFlow>(&flow)) {
    vortices->viscosity *= s;
    vortices->wave_number /= s;
  }
}

}  // namespace

void rescale(SetUp& set_up, double s) {
  Scene& scene = set_up.scene;
  scene.run.end *= s;
  if (scene.run.skin > 0.0) scene.run.skin *= s;
  if (set_up.step) set_up.step->seconds *= s;
  if (set_up.record.kind == RecordWish::Kind::every) set_up.record.amount *= s;
  scene.domain = scaled(scene.domain, s);
  scene.contacts = scaled(scene.contacts, s);
  for (Particle& particle : scene.particles) scale(particle, s);
  for (Wall& wall : scene.walls) scale(wall, s);
  scale(scene.gravity, s);
  scale(scene.flow, s);
}

Vec3 offset_of(const Node& node, const Scene& scene) {
  if (!node.is_table()) return node.vector();
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  return largest * node.table().at("diameters").vector();
}

}  // namespace grainproof::input
