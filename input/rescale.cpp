// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "input/mass.hpp"
#include "input/transforms.hpp"

namespace grainproof::input {
namespace {

// Density, moduli and velocities stay: masses go with s³, times with s, forces with s², stiffnesses with s.

/// Multiplies, and notices where what comes of a number is none, or nothing.
class Factor {
 public:
  explicit Factor(double s) : s_(s) {}

  void up(double& x) { put(x, x * s_); }
  void up_twice(double& x) { put(x, x * (s_ * s_)); }
  void down(double& x) { put(x, x / s_); }
  void up(Vec3& v) {
    for (double& x : v) up(x);
  }
  void down(Vec3& v) {
    for (double& x : v) down(x);
  }
  bool lost_any() const { return lost_; }

 private:
  void put(double& x, double scaled) {
    lost_ = lost_ || !(x == 0.0 || std::isnormal(scaled));
    x = scaled;
  }

  double s_;
  bool lost_ = false;
};

Domain scaled(Domain domain, Factor& by) {
  by.up(domain.lower);
  by.up(domain.upper);
  return domain;
}

void scale(Particle& particle, Factor& by) {
  by.up(particle.diameter);
  by.up(particle.effect_diameter);
  by.up(particle.position);
  by.down(particle.angular_velocity);
}

void scale(Wall& wall, Factor& by) {
  std::visit(Overloaded{[&](Plane& plane) { by.up(plane.point); },
                        [&](Cylinder& cylinder) {
                          by.up(cylinder.point);
                          by.up(cylinder.radius);
                        },
                        [&](Rectangle& rectangle) {
                          by.up(rectangle.lower);
                          by.up(rectangle.upper);
                        }},
             wall.shape);
  std::visit(Overloaded{[](Still&) {}, [](Translating&) {}, [&](Rotating& turning) { by.down(turning.rate); },
                        [&](Vibrating& shaking) {
                          by.up(shaking.amplitude);
                          by.down(shaking.frequency);
                        }},
             wall.motion);
}

void scale(NormalLaw& law, Factor& by) {
  auto* linear = std::get_if<LinearNormal>(&law);
  if (linear == nullptr) return;
  by.up(linear->stiffness);
  if (auto* damping = std::get_if<Damping>(&linear->dissipation)) by.up_twice(damping->value);
}

void scale(FrictionLaw& law, Factor& by) {
  std::visit(Overloaded{[](Frictionless&) {}, [](DynamicFriction&) {},
                        [&](auto& friction) { by.up(friction.stiffness); }},
             law);
}

ContactTable scaled(const ContactTable& contacts, Factor& by) {
  ContactTable out(contacts.materials());
  for (std::size_t a = 0; a < contacts.materials(); ++a)
    for (std::size_t b = a; b < contacts.materials(); ++b) {
      if (!contacts.has(a, b)) continue;
      ContactLaws laws = contacts.at(a, b);
      scale(laws.normal, by);
      scale(laws.friction, by);
      if (auto* cohesion = std::get_if<LinearCohesion>(&laws.cohesion)) by.up(cohesion->stiffness);
      out.set(a, b, std::move(laws));
    }
  return out;
}

void scale(Gravity& gravity, Factor& by) {
  std::visit(Overloaded{[&](ConstantGravity& constant) { by.down(constant.acceleration); },
                        [&](RotatingGravity& rotating) {
                          by.down(rotating.magnitude);
                          by.up(rotating.time_scale);
                        },
                        [&](CentralGravity& central) {
                          by.down(central.magnitude);
                          by.up(central.centre);
                        }},
             gravity);
}

void scale(Flow& flow, Factor& by) {
  if (auto* uniform = std::get_if<UniformFlow>(&flow)) by.up(uniform->viscosity);
  if (auto* vortices = std::get_if<TaylorGreenFlow>(&flow)) {
    by.up(vortices->viscosity);
    by.down(vortices->wave_number);
  }
}

}  // namespace

bool rescale(SetUp& set_up, double s) {
  Factor by(s);
  Scene& scene = set_up.scene;
  by.up(scene.run.end);
  if (scene.run.skin > 0.0) by.up(scene.run.skin);
  if (set_up.step) by.up(set_up.step->seconds);
  if (set_up.record.kind == RecordWish::Kind::every) by.up(set_up.record.amount);
  scene.domain = scaled(scene.domain, by);
  scene.contacts = scaled(scene.contacts, by);
  for (Particle& particle : scene.particles) scale(particle, by);
  for (Wall& wall : scene.walls) scale(wall, by);
  scale(scene.gravity, by);
  scale(scene.flow, by);
  return !by.lost_any() &&
         std::all_of(scene.particles.begin(), scene.particles.end(), [&](const Particle& p) {
           const auto material = static_cast<std::size_t>(p.material);
           return has_a_mass(scene.materials[material].density, p.diameter);
         });
}

Vec3 offset_of(const Node& node, const Scene& scene) {
  if (!node.is_table()) return node.vector();
  double largest = 0.0;
  for (const Particle& particle : scene.particles) largest = std::max(largest, particle.diameter);
  return largest * node.table().at("diameters").vector();
}

}  // namespace grainproof::input
