// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/metrics/curves.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "comparisons/metrics/mass.hpp"
#include "comparisons/metrics/pairs.hpp"

namespace grainproof {
namespace {

/// Empty where the frames correspond, else what is wrong.
std::string mismatch(const Scene& scene, const Observations& seen, const Observations& exact) {
  if (seen.frames.size() != exact.frames.size())
    return "has " + std::to_string(seen.frames.size()) + " frames where the exact solution has " +
           std::to_string(exact.frames.size());
  for (std::size_t k = 0; k < seen.frames.size(); ++k)
    if (std::abs(seen.frames[k].time - exact.frames[k].time) > 1e-6 * scene.run.step)
      return "has a frame at " + std::to_string(seen.frames[k].time) +
             " s where the exact solution has one at " + std::to_string(exact.frames[k].time) + " s";
  return {};
}

/// Chords between frames, or the mean speed between them, whichever is longer: with few frames
/// a particle that comes back has short chords.
double path_length(const Scene& scene, const Observations& exact, std::size_t particle) {
  double chords = 0.0;
  double travelled = 0.0;
  for (std::size_t k = 1; k < exact.frames.size(); ++k) {
    const Frame& a = exact.frames[k - 1];
    const Frame& b = exact.frames[k];
    chords += separation(scene.domain, a.position[particle], b.position[particle]).norm();
    travelled += 0.5 * (a.velocity[particle].norm() + b.velocity[particle].norm()) * (b.time - a.time);
  }
  return std::max(chords, travelled);
}

double longest_path(const Scene& scene, const Observations& exact) {
  double longest = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i)
    longest = std::max(longest, path_length(scene, exact, i));
  return longest;
}

double largest_speed(const Observations& exact) {
  double largest = 0.0;
  for (const Frame& frame : exact.frames)
    for (const Vec3& velocity : frame.velocity) largest = std::max(largest, velocity.norm());
  return largest;
}

/// The largest error vector so far, signed by whether it points ahead.
struct Worst {
  double size = 0.0;
  double sign = 1.0;

  void consider(const Vec3& error, const Vec3& ahead) {
    if (error.norm() <= size) return;
    size = error.norm();
    sign = error.dot(ahead) < 0.0 ? -1.0 : 1.0;
  }
  Measured relative_to(double scale) const {
    if (scale > 0.0) return Measured::of(sign * size / scale);
    return size == 0.0 ? Measured::of(0.0)
                       : Measured::none("nothing moves in the exact solution, so there is no scale");
  }
};

/// Largest spin, or where nothing turns the largest speed over its particle's radius, rad/s.
double largest_spin(const Scene& scene, const Observations& exact) {
  double largest = 0.0;
  double rolling = 0.0;
  for (const Frame& frame : exact.frames)
    for (std::size_t i = 0; i < frame.angular_velocity.size(); ++i) {
      largest = std::max(largest, frame.angular_velocity[i].norm());
      rolling = std::max(rolling, 2.0 * frame.velocity[i].norm() / scene.particles[i].diameter);
    }
  return largest > 0.0 ? largest : rolling;
}

bool turns(const Observations& seen) {
  return std::all_of(seen.frames.begin(), seen.frames.end(), [](const Frame& frame) {
    return frame.angular_velocity.size() == frame.position.size();
  });
}

}  // namespace

double kinetic_energy(const Scene& scene, const Frame& frame) {
  double sum = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const Particle& body = scene.particles[i];
    if (body.fixed) continue;
    sum += 0.5 * mass_of(scene, body) * frame.velocity[i].squaredNorm();
    if (!frame.angular_velocity.empty())
      sum += 0.5 * inertia_of(scene, body) * frame.angular_velocity[i].squaredNorm();
  }
  return sum;
}

Measured position_error(const Scene& scene, const Observations& seen, const Observations& exact) {
  if (const std::string wrong = mismatch(scene, seen, exact); !wrong.empty()) return Measured::none(wrong);
  Worst worst;
  for (std::size_t k = 0; k < seen.frames.size(); ++k)
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
      worst.consider(separation(scene.domain, exact.frames[k].position[i], seen.frames[k].position[i]),
                     separation(scene.domain, exact.frames.front().position[i], exact.frames[k].position[i]));
  return worst.relative_to(longest_path(scene, exact));
}

Measured velocity_error(const Scene& scene, const Observations& seen, const Observations& exact) {
  if (const std::string wrong = mismatch(scene, seen, exact); !wrong.empty()) return Measured::none(wrong);
  Worst worst;
  for (std::size_t k = 0; k < seen.frames.size(); ++k)
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
      worst.consider(seen.frames[k].velocity[i] - exact.frames[k].velocity[i], exact.frames[k].velocity[i]);
  return worst.relative_to(largest_speed(exact));
}

Measured angular_velocity_error(const Scene& scene, const Observations& seen, const Observations& exact) {
  if (const std::string wrong = mismatch(scene, seen, exact); !wrong.empty()) return Measured::none(wrong);
  if (!turns(exact)) return Measured::none("the exact solution has no angular velocities");
  if (!turns(seen)) return Measured::none("there are no angular velocities; is `rotation` on?");
  Worst worst;
  for (std::size_t k = 0; k < seen.frames.size(); ++k)
    for (std::size_t i = 0; i < scene.particles.size(); ++i)
      worst.consider(seen.frames[k].angular_velocity[i] - exact.frames[k].angular_velocity[i],
                     exact.frames[k].angular_velocity[i]);
  return worst.relative_to(largest_spin(scene, exact));
}

Measured kinetic_energy_error(const Scene& scene, const Observations& seen, const Observations& exact) {
  if (const std::string wrong = mismatch(scene, seen, exact); !wrong.empty()) return Measured::none(wrong);
  double squares = 0.0;
  double sum = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < seen.frames.size(); ++k) {
    const double right = kinetic_energy(scene, exact.frames[k]);
    const double error = kinetic_energy(scene, seen.frames[k]) - right;
    squares += error * error;
    sum += error;
    largest = std::max(largest, right);
  }
  if (largest == 0.0) return Measured::none("nothing moves in the exact solution, so there is no scale");
  return Measured::of(std::copysign(std::sqrt(squares / static_cast<double>(seen.frames.size())), sum) /
                      largest);
}

}  // namespace grainproof
