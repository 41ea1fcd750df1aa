// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/walls.hpp"

#include <cmath>
#include <numbers>

#include "model/laws.hpp"

namespace grainproof::reference {
namespace {

Vec3 reference_point(const WallShape& shape) {
  return std::visit(Overloaded{[](const Rectangle& rectangle) { return rectangle.lower; },
                               [](const auto& other) { return other.point; }},
                    shape);
}

/// What a wall turns about within itself; a rectangle does not turn.
Vec3 axis_of(const WallShape& shape) {
  return std::visit(Overloaded{[](const Plane& plane) -> Vec3 { return plane.normal; },
                               [](const Cylinder& cylinder) -> Vec3 { return cylinder.axis; },
                               [](const Rectangle&) -> Vec3 { return Vec3::Zero(); }},
                    shape);
}

WallShape shifted(const WallShape& shape, const Vec3& shift) {
  return std::visit(Overloaded{[&](Rectangle rectangle) -> WallShape {
                                 rectangle.lower += shift;
                                 rectangle.upper += shift;
                                 return rectangle;
                               },
                               [&](auto other) -> WallShape {
                                 other.point += shift;
                                 return other;
                               }},
                    shape);
}

void place(WallNow& now, const Wall& drawn, const Vec3& shift, const Vec3& velocity) {
  now.shape = shifted(drawn.shape, shift);
  now.reference = reference_point(now.shape);
  now.velocity = velocity;
}

WallNow as_drawn(const Wall& wall) {
  WallNow now{.shape = wall.shape,
              .material = wall.material,
              .reference = reference_point(wall.shape),
              .moving = !std::holds_alternative<Still>(wall.motion)};
  if (const auto* rotating = std::get_if<Rotating>(&wall.motion))
    now.spin = rotating->rate * axis_of(wall.shape);
  return now;
}

}  // namespace

Walls::Walls(const Scene& scene) : drawn_(scene.walls) {
  for (const Wall& wall : drawn_) now_.push_back(as_drawn(wall));
  move_to(0.0);
}

void Walls::move_to(double time) {
  for (std::size_t w = 0; w < now_.size(); ++w)
    std::visit(Overloaded{[](const Still&) {}, [](const Rotating&) {},
                          [&](const Translating& motion) {
                            place(now_[w], drawn_[w], motion.velocity * time, motion.velocity);
                          },
                          [&](const Vibrating& motion) {
                            const double rate = 2.0 * std::numbers::pi * motion.frequency;
                            const double angle = rate * time + motion.phase;
                            place(now_[w], drawn_[w],
                                  motion.amplitude * (std::sin(angle) - std::sin(motion.phase)),
                                  motion.amplitude * (rate * std::cos(angle)));
                          }},
               drawn_[w].motion);
}

}  // namespace grainproof::reference
