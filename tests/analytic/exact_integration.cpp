// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/analytic/exact_integration.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <stdexcept>

#include "analytic/contact_scales.hpp"

namespace grainproof::analytic::exact {
namespace {

const Real pi = boost::math::constants::pi<Real>();

Vector vector(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
Vector position(const State& s, int body) {
  return {s[3 * body], s[3 * body + 1], s[3 * body + 2]};
}
Vector velocity(const State& s, int body) {
  return position(s, body + 2);
}
Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Vector operator*(const Real& f, const Vector& a) {
  return {f * a[0], f * a[1], f * a[2]};
}
Real dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Real mass(const Scene& scene, const Particle& p) {
  return Real(scene.materials[p.material].density) * pi / 6 * Real(p.diameter) * p.diameter * p.diameter;
}

Real damping_of(const LinearNormal& law, const Real& m) {
  if (const auto* given = std::get_if<Damping>(&law.dissipation)) return given->value;
  const Real e = std::get<Restitution>(law.dissipation).value;
  // The inversion of the clamped law is tested by its rebound, not repeated here.
  if (law.no_tension) return damping(law, static_cast<double>(m));
  if (e == 0) return 2 * sqrt(m * law.stiffness);
  return -2 * log(e) * sqrt(m * law.stiffness / (pi * pi + log(e) * log(e)));
}

}  // namespace

World::World(const Scene& scene) : scene_(scene), wall_(!scene.walls.empty()) {
  gravity_ = vector(std::get<ConstantGravity>(scene.gravity).acceleration);
  const std::size_t count = std::min<std::size_t>(scene.particles.size(), 2);
  for (std::size_t i = 0; i < count; ++i) {
    const Particle& p = scene.particles[i];
    mass_[i] = mass(scene, p);
    if (const auto* flow = std::get_if<UniformFlow>(&scene.flow)) {
      stream_ = vector(flow->velocity);
      drag_rate_[i] =
          18 * Real(flow->viscosity) / (Real(scene.materials[p.material].density) * p.diameter * p.diameter);
    }
  }
  meets_ = wall_ || count == 2;
  if (meets_) set_laws(scene.contacts.at(0, 0), set_geometry());
}

/// Returns the effective mass.
Real World::set_geometry() {
  const Particle& two = scene_.particles[wall_ ? 0 : 1];
  touching_ = Real(two.diameter) / 2;
  effect_ = Real(two.effect_diameter) / 2;
  if (wall_) {
    const auto& plane = std::get<Plane>(scene_.walls.front().shape);
    wall_normal_ = vector(plane.normal);
    wall_point_ = vector(plane.point);
    return mass_[0];
  }
  const Particle& one = scene_.particles[0];
  touching_ += Real(one.diameter) / 2;
  effect_ += Real(one.effect_diameter) / 2;
  return one.fixed ? mass_[1] : Real(mass_[0] * mass_[1] / (mass_[0] + mass_[1]));
}

void World::set_laws(const ContactLaws& laws, const Real& m) {
  const auto& normal = std::get<LinearNormal>(laws.normal);
  stiffness_ = normal.stiffness;
  no_tension_ = normal.no_tension;
  damping_ = damping_of(normal, m);
  if (const auto* c = std::get_if<LinearCohesion>(&laws.cohesion)) cohesion_ = c->stiffness;
  const auto rub = [this](double coefficient, const Real& viscosity) {
    coefficient_ = coefficient;
    viscosity_ = viscosity;
  };
  const Real impact_time = pi * sqrt(m / stiffness_);
  std::visit(
      Overloaded{[](const Frictionless&) {}, [&](const DynamicFriction& f) { rub(f.coefficient, -1); },
                 [&](const StepFriction& f) { rub(f.coefficient, Real(f.stiffness) * scene_.run.step); },
                 [&](const CollisionTimeFriction& f) { rub(f.coefficient, f.stiffness * impact_time); },
                 [&](const DampedFriction& f) { rub(f.coefficient, f.stiffness * impact_time + damping_); },
                 [](const HistoryFriction&) { throw std::logic_error("no history here"); }},
      laws.friction);
}

State World::start() const {
  State state{};
  for (std::size_t i = 0; i < std::min<std::size_t>(scene_.particles.size(), 2); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      // A single sphere against a wall is body 2.
      const std::size_t body = wall_ ? 1 : i;
      state[3 * body + axis] = scene_.particles[i].position[axis];
      state[6 + 3 * body + axis] = scene_.particles[i].velocity[axis];
    }
  return state;
}

World::Contact World::contact(const State& state) const {
  Contact c;
  const Vector separation = position(state, 1) - (wall_ ? wall_point_ : position(state, 0));
  const Vector relative = velocity(state, 1) - (wall_ ? Vector{} : velocity(state, 0));
  const Real distance = wall_ ? dot(separation, wall_normal_) : sqrt(dot(separation, separation));
  c.normal = wall_ ? wall_normal_ : (1 / distance) * separation;
  c.body_overlap = touching_ - distance;
  c.effect_overlap = effect_ - distance;
  c.normal_velocity = dot(relative, c.normal);
  c.slip = relative - c.normal_velocity * c.normal;
  c.slip_speed = sqrt(dot(c.slip, c.slip));
  return c;
}

Real World::elastic_and_damping(const Contact& c) const {
  return stiffness_ * c.body_overlap - damping_ * c.normal_velocity;
}

Regime World::regime(const State& state) const {
  if (!meets_) return {};
  const Contact c = contact(state);
  const Real pushing = elastic_and_damping(c);
  Regime r{c.body_overlap > 0, cohesion_ > 0 && c.effect_overlap > 0, false, false};
  r.pulling = r.bodies && pushing < 0;
  r.creeping = r.bodies && viscosity_ >= 0 && viscosity_ * c.slip_speed < coefficient_ * abs(pushing);
  return r;
}

Vector World::force_on_second(const State& state, const Regime& regime) const {
  const Contact c = contact(state);
  Vector force{};
  if (regime.effects) force = -cohesion_ * c.effect_overlap * c.normal;
  if (!regime.bodies || (no_tension_ && regime.pulling)) return force;
  const Real normal = elastic_and_damping(c);
  force = force + normal * c.normal;
  if (coefficient_ == 0 || c.slip_speed == 0) return force;
  const Real over_speed =
      regime.creeping ? viscosity_ : coefficient_ * (regime.pulling ? -normal : normal) / c.slip_speed;
  return force - over_speed * c.slip;
}

std::array<Vector, 2> World::accelerations(const State& state, const Regime& regime) const {
  const Vector force = meets_ ? force_on_second(state, regime) : Vector{};
  const int first = wall_ ? 1 : 0;
  std::array<Vector, 2> a{};
  for (std::size_t i = 0; i + first < 2 && i < scene_.particles.size(); ++i) {
    const int body = static_cast<int>(i) + first;
    if (scene_.particles[i].fixed) continue;
    const Real sign = body == 1 ? 1 : -1;
    a[body] = gravity_ + (sign / mass_[i]) * force + drag_rate_[i] * (stream_ - velocity(state, body));
  }
  return a;
}

State World::advanced(const State& state, const Regime& regime, const Real& step) const {
  using namespace boost::numeric::odeint;
  runge_kutta_fehlberg78<State, Real, State, Real, array_algebra> method;
  State next = state;
  const auto rates = [&](const State& s, State& rate, const Real&) {
    const auto a = accelerations(s, regime);
    for (int i = 0; i < 6; ++i) {
      rate[i] = s[6 + i];
      rate[6 + i] = a[i / 3][i % 3];
    }
  };
  method.do_step(rates, next, Real(0), step);
  return next;
}

void World::go(State& state, Regime& regime, const Real& span) const {
  Real left = span;
  while (left > 0) {
    const auto breaks = [&](const State& later) { return !(this->regime(later) == regime); };
    State next = advanced(state, regime, left);
    if (!breaks(next)) {
      state = next;
      return;
    }
    Real low = 0, high = left;
    for (int halving = 0; halving < 100; ++halving) {
      const Real middle = (low + high) / 2;
      (breaks(advanced(state, regime, middle)) ? high : low) = middle;
    }
    state = advanced(state, regime, high);
    regime = this->regime(state);
    left -= high;
  }
}

std::vector<State> World::integrate(const std::vector<double>& times, double step) const {
  std::vector<State> states;
  State state = start();
  Regime regime = this->regime(state);
  Real now = 0;
  for (const double time : times) {
    const int steps = std::max(1, static_cast<int>(ceil((Real(time) - now) / step)));
    const Real span = (Real(time) - now) / steps;
    for (int i = 0; span > 0 && i < steps; ++i) go(state, regime, span);
    now = time;
    states.push_back(state);
  }
  return states;
}

}  // namespace grainproof::analytic::exact
