// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/fields.hpp"

#include "reference_cpu/laws/drag.hpp"
#include "reference_cpu/laws/flow.hpp"
#include "reference_cpu/laws/gravity.hpp"

namespace grainproof::reference {
namespace {

void accelerate(const GravityField& gravity, Bodies& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies.body[i];
    Vec3& acceleration = bodies.acceleration[i];
    acceleration = body.fixed() ? Vec3::Zero().eval()
                                : (acceleration * body.inverse_mass + gravity.at(body.position)).eval();
  }
}

void accelerate_spins(Bodies& bodies) {
  for (std::size_t i = 0; i < bodies.spin.size(); ++i)
    bodies.angular_acceleration[i] *= bodies.spin[i].inverse_inertia;
}

Vec3 drag_on(const Flow& flow, const DragSetting& drag, const Bodies& bodies, std::size_t i) {
  const Body& body = bodies.body[i];
  const double rate = bodies.drag_rate[i] / (1.0 + 0.5 * drag.implicit_over * bodies.drag_rate[i]);
  return drag_acceleration(rate, fluid_velocity(flow, body.position), body.velocity);
}

void add_drag(const Flow& flow, const DragSetting& drag, Bodies& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!bodies.body[i].fixed()) bodies.acceleration[i] += drag_on(flow, drag, bodies, i);
}

void log_fields(const Scene& scene, const GravityField& gravity, const DragSetting& drag,
                const Bodies& bodies, ForceLog& log) {
  const bool flow = !bodies.drag_rate.empty();
  log.gravity.assign(bodies.size(), Vec3::Zero());
  if (flow) (drag.acts ? log.drag : log.fluid).assign(bodies.size(), Vec3::Zero());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies.body[i].fixed()) continue;
    log.gravity[i] = bodies.mass[i] * gravity.at(bodies.body[i].position);
    if (!flow) continue;
    if (drag.acts)
      log.drag[i] = bodies.mass[i] * drag_on(scene.flow, drag, bodies, i);
    else
      log.fluid[i] = fluid_velocity(scene.flow, bodies.body[i].position);
  }
}

}  // namespace

void add_fields(const Scene& scene, double time, const DragSetting& drag, Bodies& bodies, ForceLog* log) {
  const GravityField gravity(scene.gravity, time);
  accelerate(gravity, bodies);
  accelerate_spins(bodies);
  if (drag.acts && !bodies.drag_rate.empty()) add_drag(scene.flow, drag, bodies);
  if (log) log_fields(scene, gravity, drag, bodies, *log);
}

}  // namespace grainproof::reference
