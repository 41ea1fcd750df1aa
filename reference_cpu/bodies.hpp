// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/scene.hpp"

namespace grainproof::reference {

/// What the pair loop reads of a particle, in one cache line.
struct alignas(64) Body {
  Vec3 position;
  double radius;
  Vec3 velocity;
  double inverse_mass;  ///< 1/kg; zero for a fixed particle

  bool fixed() const { return inverse_mass == 0.0; }
};

struct alignas(32) Spin {
  Vec3 angular_velocity;   ///< rad/s
  double inverse_inertia;  ///< 1/(kg m²); zero for a fixed particle
};

/// All particles. Every array has the same length, those of turning none without it.
struct Bodies {
  std::vector<Body> body;
  std::vector<Spin> spin;
  std::vector<Vec3> acceleration;          ///< m/s²; holds the force while contacts are being summed
  std::vector<Vec3> angular_acceleration;  ///< rad/s²; the torque while contacts are being summed
  /// Half-step velocities and spins, where the integrator predicts: of the step that led here. Else empty.
  std::vector<Vec3> half_velocity, half_spin;
  bool predicted = false;               ///< `velocity` is the prediction, and the half-step ones are held
  std::vector<Quaternion> orientation;  ///< empty unless the scene asks for it
  std::vector<double> mass;             ///< kg, of fixed particles too
  std::vector<double> reach;            ///< m; effect radius where the scene has cohesion, else radius
  std::vector<double> drag_rate;        ///< 1/s, the inverse of the response time; empty without flow
  std::vector<std::int32_t> material;
  std::vector<std::int32_t> origin;  ///< index in the scene, and so in order of ids

  std::size_t size() const { return body.size(); }
  bool turning() const { return !spin.empty(); }
  bool predicts() const { return !half_velocity.empty(); }
};

/// The body `order[i]` becomes the body i. Accelerations are not kept.
void reorder(Bodies& bodies, const std::vector<std::int32_t>& order);

/// Values of all bodies in the order of the scene.
template <class Value>
std::vector<Value> in_scene_order(const Bodies& bodies, const std::vector<Value>& values) {
  std::vector<Value> sorted(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) sorted[bodies.origin[i]] = values[i];
  return sorted;
}

/// Turns faster for `duration` (s); nothing where nothing turns.
inline void kick_spins(Bodies& bodies, double duration) {
  for (std::size_t i = 0; i < bodies.spin.size(); ++i)
    bodies.spin[i].angular_velocity += bodies.angular_acceleration[i] * duration;
}

/// How all particles move; the second array is empty where nothing turns.
struct Motion {
  std::vector<Vec3> velocity;          ///< m/s
  std::vector<Vec3> angular_velocity;  ///< rad/s
};

/// Once the present accelerations have acted for `pending` (s) more. While velocities are predictions, those
/// held.
Motion motion_after(const Bodies& bodies, double pending);

/// Whether forces take velocities predicted for the step boundary.
constexpr bool predicts_velocities(Integrator integrator) {
  return integrator == Integrator::velocity_verlet_predicted || integrator == Integrator::onset_corrected;
}

/// Whether those of the middle of the step are held beside what forces take.
constexpr bool holds_half_steps(Integrator integrator) {
  return predicts_velocities(integrator) || integrator == Integrator::velocity_verlet_implicit;
}

Bodies bodies_of(const Scene& scene);

bool has_cohesion(const Scene& scene);

/// The largest and the smallest distance from a centre at which a particle of the scene acts.
double largest_reach(const Scene& scene);
double smallest_reach(const Scene& scene);

}  // namespace grainproof::reference
