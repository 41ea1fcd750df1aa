// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "reference_cpu/ledger_keeper.hpp"
#include "reference_cpu/surfaces.hpp"

namespace grainproof::reference {
namespace {

Vec3 relative_velocity(const Encounter& meet, const Bodies& bodies) {
  const Vec3& first = meet.with_wall() ? meet.wall_velocity : bodies.body[meet.first].velocity;
  return bodies.body[meet.second].velocity - first;
}

Vec3 sweep_of(const OnsetEvent& event, const Bodies& bodies) {
  Vec3 sum = event.arms.second * bodies.spin[event.meet.second].angular_velocity;
  if (!event.meet.with_wall()) sum += event.arms.first * bodies.spin[event.meet.first].angular_velocity;
  return sum;
}

}  // namespace

// The energy of the springs is that of where they are, so all that an event takes is dissipated.
void LedgerKeeper::half_of(const OnsetEvent& event, const Bodies& bodies, const Walls& walls,
                           const PeriodicBox& box) {
  const Encounter& meet = event.meet;
  const Vec3 velocity = relative_velocity(meet, bodies);
  sums_.dissipated_normal.add(-0.5 * event.push.dot(velocity));
  Vec3 slip = velocity;
  if (bodies.turning()) {
    slip -= sweep_of(event, bodies).cross(meet.normal);
    const Vec3& of_first =
        meet.with_wall() ? walls[wall_of(meet)].spin : bodies.spin[meet.first].angular_velocity;
    sums_.taken_by_rolling.add(-0.5 * event.resist.dot(bodies.spin[meet.second].angular_velocity - of_first));
  }
  sums_.taken_by_friction.add(-0.5 * event.rub.dot(slip));
  const Vec3 half = 0.5 * (event.push + event.rub);
  if (meet.with_wall()) {
    book_on_wall(event, bodies, walls, box);
  } else {
    if (bodies.body[meet.first].fixed()) sums_.support.add(half);
    if (bodies.body[meet.second].fixed()) sums_.support.add(-half);
  }
}

void LedgerKeeper::book_on_wall(const OnsetEvent& event, const Bodies& bodies, const Walls& walls,
                                const PeriodicBox& box) {
  const Encounter& meet = event.meet;
  const WallNow& wall = walls[wall_of(meet)];
  const Body& body = bodies.body[meet.second];
  const Vec3 half = 0.5 * (event.push + event.rub), turn = 0.5 * event.resist;
  const Vec3 surface = event.centre - (body.radius - meet.overlap) * meet.normal;
  const Vec3 arm = std::visit([&](const auto& shape) { return arm_to(shape, surface, box); }, wall.shape);
  sums_.support.add(half);
  sums_.wall_work.add(half.dot(meet.wall_velocity) + turn.dot(wall.spin));
  sums_.walls[wall_of(meet)].impulse.add(half);
  sums_.walls[wall_of(meet)].angular_impulse.add(arm.cross(half) + turn);
}

}  // namespace grainproof::reference
