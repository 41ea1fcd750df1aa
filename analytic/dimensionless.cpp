// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/dimensionless.hpp"

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

namespace grainproof::analytic {
namespace {

double taylor_green_speed(double x, double y, double z) {
  const double sx = std::sin(x), sy = std::sin(y), sz = std::sin(z);
  const double cx = std::cos(x), cy = std::cos(y), cz = std::cos(z);
  return std::hypot(cx * sy * sz, sx * cy * sz, 2.0 * sx * sy * cz);
}

}  // namespace

double stokes_number(double density, double diameter, double viscosity, double speed, double length) {
  return density * diameter * diameter * speed / (18.0 * viscosity * length);
}

double taylor_green_mean_speed() {
  // One octant of a vortex stands for all: each component is even about π/2.
  const double quarter = boost::math::constants::half_pi<double>();
  using Rule = boost::math::quadrature::gauss<double, 60>;
  const double integral = Rule::integrate(
      [&](double x) {
        return Rule::integrate(
            [&](double y) {
              return Rule::integrate([&](double z) { return taylor_green_speed(x, y, z); }, 0.0, quarter);
            },
            0.0, quarter);
      },
      0.0, quarter);
  return integral / (quarter * quarter * quarter);
}

double stickiness_number(double reach, double cohesion_stiffness, double restitution, double speed,
                         double mass) {
  const double binding = reach * std::sqrt(cohesion_stiffness);
  return binding / (restitution * std::hypot(binding, speed * std::sqrt(mass)));
}

double sticking_speed_of_source(double reach, double cohesion_stiffness, double restitution, double mass) {
  const double lost = std::sqrt((1.0 - restitution) * (1.0 + restitution));
  return reach * std::sqrt(cohesion_stiffness / mass) * lost / restitution;
}

}  // namespace grainproof::analytic
