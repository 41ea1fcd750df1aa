// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <numbers>

#include "analytic/contact_scales.hpp"
#include "analytic/linear_system.hpp"
#include "analytic/possible_contacts.hpp"
#include "model/errors.hpp"

namespace grainproof::analytic {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double inertia_factor = 0.4;  // rotation.1

/// Two bodies, or a body and a wall (index −1), that touch; `normal` points from the first to the second.
struct Touch {
  Index first, second;
  Vec3 normal;
  double overlap, effect_overlap, distance;
  double mass;  ///< effective, kg
  const ContactLaws* laws;
};

/// Adds `factor` times the product of a row with itself. A contact moves two bodies, and all else of its row
/// is zero.
void add_square(MatrixXd& matrix, double factor, const VectorXd& row) {
  std::vector<Index> moved;
  for (Index i = 0; i < row.size(); ++i)
    if (row[i] != 0.0) moved.push_back(i);
  for (const Index i : moved)
    for (const Index j : moved) matrix(i, j) += factor * row[i] * row[j];
}

class Assembly {
 public:
  Assembly(const Scene& scene, Prestress prestress, const StepOf& step)
      : scene_(scene), prestress_(prestress), step_(step) {
    for (const Particle& particle : scene.particles) {
      first_coordinate_.push_back(particle.fixed ? -1 : coordinates_);
      if (!particle.fixed) coordinates_ += scene.rotation ? 6 : 3;
    }
    mass_ = VectorXd::Ones(coordinates_);
    stiffness_ = remembered_ = damping_ = drag_ = MatrixXd::Zero(coordinates_, coordinates_);
  }

  LinearSystem assembled() {
    weigh_bodies();
    for (std::size_t i = 0; i < scene_.particles.size(); ++i) {
      for (std::size_t j = i + 1; j < scene_.particles.size(); ++j) add_pair(i, j);
      for (const Wall& wall : scene_.walls) add_wall(i, wall);
    }
    const VectorXd weight = mass_.cwiseSqrt().cwiseInverse();
    const auto weighted = [&](const MatrixXd& matrix) -> MatrixXd {
      return weight.asDiagonal() * matrix * weight.asDiagonal();
    };
    return {weighted(stiffness_), weighted(remembered_), weighted(damping_), drag_};
  }

 private:
  double mass_of(std::size_t i) const {
    const Particle& particle = scene_.particles[i];
    return particle.fixed ? std::numeric_limits<double>::infinity()
                          : sphere_mass(scene_.materials[particle.material].density, particle.diameter);
  }

  void weigh_bodies() {
    for (std::size_t i = 0; i < scene_.particles.size(); ++i) {
      const Index at = first_coordinate_[i];
      if (at < 0) continue;
      const Particle& particle = scene_.particles[i];
      mass_.segment<3>(at).setConstant(mass_of(i));
      drag_.diagonal().segment<3>(at).setConstant(
          drag_rate(scene_.flow, scene_.materials[particle.material].density, particle.diameter));
      if (scene_.rotation)
        mass_.segment<3>(at + 3).setConstant(inertia_factor * mass_of(i) * 0.25 * particle.diameter *
                                             particle.diameter);
    }
  }

  void add_pair(std::size_t i, std::size_t j) {
    const Particle &one = scene_.particles[i], &other = scene_.particles[j];
    if (one.fixed && other.fixed) return;
    Vec3 apart = other.position - one.position;
    for (int axis = 0; axis < 3; ++axis)
      if (scene_.domain.periodic(axis)) {
        const double period = scene_.domain.extent()[axis];
        apart[axis] -= period * std::round(apart[axis] / period);
      }
    const double distance = apart.norm(), overlap = 0.5 * (one.diameter + other.diameter) - distance;
    if (overlap <= 0.0) return;
    add({static_cast<Index>(i), static_cast<Index>(j), apart / distance, overlap,
         0.5 * (one.effect_diameter + other.effect_diameter) - distance, distance,
         effective_mass(mass_of(i), mass_of(j)), &scene_.contacts.at(one.material, other.material)});
  }

  void add_wall(std::size_t i, const Wall& wall) {
    const Particle& particle = scene_.particles[i];
    const auto* plane = std::get_if<Plane>(&wall.shape);
    if (!plane) throw InputRefused("found wall " + wall.name + "; expected planes only");
    const double height = (particle.position - plane->point).dot(plane->normal);
    const double overlap = 0.5 * particle.diameter - height;
    if (particle.fixed || overlap <= 0.0) return;
    add({-1, static_cast<Index>(i), plane->normal, overlap, 0.5 * particle.effect_diameter - height,
         std::numeric_limits<double>::infinity(), mass_of(i),
         &scene_.contacts.at(particle.material, wall.material)});
  }

  /// Velocity of the second body against the first along `direction`, as a row over all coordinates;
  /// `arms` are those of rotation.2, zero along the normal.
  VectorXd relative(const Touch& touch, const Vec3& direction, const std::pair<double, double>& arms) const {
    VectorXd row = VectorXd::Zero(coordinates_);
    const auto add_body = [&](Index body, double sign, double arm) {
      const Index at = body < 0 ? -1 : first_coordinate_[body];
      if (at < 0) return;
      row.segment<3>(at) += sign * direction;
      if (scene_.rotation) row.segment<3>(at + 3) -= arm * touch.normal.cross(direction);
    };
    add_body(touch.first, -1.0, arms.first);
    add_body(touch.second, 1.0, arms.second);
    return row;
  }

  void add(const Touch& touch) {
    const auto* normal = std::get_if<LinearNormal>(&touch.laws->normal);
    if (!normal) throw InputRefused("found a contact by Hertz' law; expected linear ones");
    double stiffness = normal->stiffness, force = stiffness * touch.overlap;
    if (const auto* cohesion = std::get_if<LinearCohesion>(&touch.laws->cohesion);
        cohesion && touch.effect_overlap > 0.0) {
      stiffness -= cohesion->stiffness;
      force -= cohesion->stiffness * touch.effect_overlap;
    }
    const double eta = analytic::damping(*normal, touch.mass);
    const VectorXd along = relative(touch, touch.normal, {0.0, 0.0});
    add_square(stiffness_, stiffness, along);
    add_square(damping_, refined(eta, normal->stiffness, touch.mass), along);
    const Vec3 one = touch.normal.unitOrthogonal(), other = touch.normal.cross(one);
    for (const Vec3& direction : {one, other}) {
      if (prestress_ == Prestress::kept) {
        const VectorXd across = relative(touch, direction, {0.0, 0.0});
        add_square(stiffness_, -force / touch.distance, across);
      }
      add_friction(touch, direction, eta);
    }
  }

  double refined(double eta, double stiffness, double mass) const {
    const double c = 0.5 * step_.step * eta / mass;
    const double kappa = 0.5 * step_.step * step_.step * stiffness / mass;
    switch (step_.weakening) {
      case Weakening::by_spring:
        return eta * (1.0 + c) / (1.0 + c + kappa);
      case Weakening::by_itself:
        return eta / (1.0 + c);
      case Weakening::none:
        break;
    }
    return eta;
  }

  /// c of friction.2.
  double creep_rate(const Touch& touch, double eta) const {
    const double impact_time =
        std::numbers::pi * std::sqrt(touch.mass / std::get<LinearNormal>(touch.laws->normal).stiffness);
    return std::visit(
        Overloaded{
            [](const auto&) -> double { throw InputRefused("found friction without a static branch"); },
            [&](const StepFriction& law) { return law.stiffness * step_.step; },
            [&](const CollisionTimeFriction& law) { return law.stiffness * impact_time; },
            [&](const DampedFriction& law) { return law.stiffness * impact_time + eta; },
        },
        touch.laws->friction);
  }

  void add_friction(const Touch& touch, const Vec3& direction, double eta) {
    if (std::holds_alternative<Frictionless>(touch.laws->friction)) return;
    const auto* spring = std::get_if<HistoryFriction>(&touch.laws->friction);
    const double shortened = spring && spring->arm == TorqueArm::overlap ? 0.5 * touch.overlap : 0.0;
    const auto arm = [&](Index body) {
      return body < 0 ? 0.0 : 0.5 * scene_.particles[body].diameter - shortened;
    };
    const VectorXd slip = relative(touch, direction, {arm(touch.first), arm(touch.second)});
    const double mass = 1.0 / slip.dot(mass_.cwiseInverse().cwiseProduct(slip));
    if (!spring) {
      add_square(damping_, refined(creep_rate(touch, eta), 0.0, mass), slip);
      return;
    }
    add_square(remembered_, spring->stiffness, slip);
    add_square(damping_, refined(spring->damping_ratio * eta, spring->stiffness, mass), slip);
  }

  const Scene& scene_;
  Prestress prestress_;
  StepOf step_;
  Index coordinates_ = 0;
  std::vector<Index> first_coordinate_;  ///< of each particle; −1 for a fixed one
  VectorXd mass_;
  MatrixXd stiffness_, remembered_, damping_, drag_;
};

}  // namespace

LinearSystem linearised(const Scene& scene, Prestress prestress, const StepOf& step) {
  return Assembly(scene, prestress, step).assembled();
}

}  // namespace grainproof::analytic
