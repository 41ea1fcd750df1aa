// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/build_options.hpp"

#include <algorithm>

#include "opencl/near_walls.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

/// Materials that can meet: those of particles with each other and with the walls within reach.
std::vector<PairCoefficients> laws_in_play(const Scene& scene, const NearWalls& near) {
  std::vector<char> of_particle(scene.materials.size()), of_wall(scene.materials.size());
  for (const Particle& p : scene.particles) of_particle[static_cast<std::size_t>(p.material)] = 1;
  near.each([&](const auto& wall) { of_wall[static_cast<std::size_t>(wall.material)] = 1; });
  std::vector<PairCoefficients> laws;
  for (std::size_t a = 0; a < scene.materials.size(); ++a)
    for (std::size_t b = 0; b < scene.materials.size(); ++b)
      if (of_particle[a] && (of_particle[b] || of_wall[b]) && scene.contacts.has(a, b))
        laws.push_back(coefficients_of(scene, a, b));
  return laws;
}

FlowKind kind_of(const Flow& flow) {
  return std::visit(Overloaded{[](const NoFlow&) { return FlowKind::none; },
                               [](const UniformFlow&) { return FlowKind::uniform; },
                               [](const TaylorGreenFlow&) { return FlowKind::taylor_green; }},
                    flow);
}

GravityKind kind_of(const Gravity& gravity) {
  return std::visit(Overloaded{[](const ConstantGravity& g) {
                                 return g.acceleration.isZero(0.0) ? GravityKind::none
                                                                   : GravityKind::constant;
                               },
                               [](const RotatingGravity&) { return GravityKind::rotating; },
                               [](const CentralGravity&) { return GravityKind::central; }},
                    gravity);
}

std::string file_of(FlowKind kind) {
  switch (kind) {
    case FlowKind::none:
      return "flow_none.cl";
    case FlowKind::uniform:
      return "flow_uniform.cl";
    case FlowKind::taylor_green:
      return "flow_taylor_green.cl";
  }
  return "";
}

std::string file_of(GravityKind kind) {
  switch (kind) {
    case GravityKind::none:
      return "gravity_none.cl";
    case GravityKind::constant:
      return "gravity_constant.cl";
    case GravityKind::rotating:
      return "gravity_rotating.cl";
    case GravityKind::central:
      return "gravity_central.cl";
  }
  return "";
}

std::string velocity_file(Precision precision) {
  return precision == Precision::double_precision ? "velocity_plain.cl" : "velocity_compensated.cl";
}

}  // namespace

std::vector<std::string> number_files(Precision precision, bool pocl) {
  const std::string math = pocl ? "math_pocl.cl" : "math_plain.cl";
  switch (precision) {
    case Precision::single_precision:
      return {"prelude.cl", "real_single.cl", math, "position_fixed.cl", "world.cl", "faults.cl", "sizes.cl"};
    case Precision::mixed_precision:
      return {"prelude.cl",       "real_mixed.cl", math,        "position_double.cl",
              "lengths_mixed.cl", "world.cl",      "faults.cl", "sizes.cl"};
    case Precision::double_precision:
      break;
  }
  return {"prelude.cl",        "real_double.cl", math,        "position_double.cl",
          "lengths_double.cl", "world.cl",       "faults.cl", "sizes.cl"};
}

BuildOptions build_options(const Scene& scene, const Request& request, Precision precision, bool small) {
  const NearWalls near = near_walls(scene);
  const auto laws = laws_in_play(scene, near);
  BuildOptions o;
  o.precision = precision;
  o.integrator = scene.run.integrator;
  const auto any = [&](const auto& test) { return std::any_of(laws.begin(), laws.end(), test); };
  o.friction = any([](const auto& law) { return law.friction > 0.0; });
  o.history = any([](const auto& law) { return law.history.present; });
  o.hertz = any([](const auto& law) { return law.hertz; });
  o.rotation = scene.rotation;
  o.rolling_constant = any([](const auto& law) { return law.rolls == RollingKind::constant; });
  o.rolling_spring = any([](const auto& law) { return law.rolls == RollingKind::spring; });
  o.orientation = scene.orientation;
  o.cohesion = any([](const auto& law) { return law.cohesion > 0.0; });
  o.planes = !near.planes.empty();
  o.rectangles = !near.rectangles.empty();
  o.cylinders = !near.cylinders.empty();
  o.moving_walls = near.any_moves();
  for (int axis = 0; axis < 3; ++axis)
    o.periodic[static_cast<std::size_t>(axis)] = scene.domain.periodic(axis);
  o.flow = kind_of(scene.flow);
  o.gravity = kind_of(scene.gravity);
  o.many_materials = scene.materials.size() > 1;
  o.ledger = request.ledger;
  o.small = small;
  return o;
}

BuildOptions with_every_stage(BuildOptions lean) {
  lean.friction = lean.cohesion = lean.planes = lean.rectangles = lean.many_materials = lean.ledger = true;
  lean.history = lean.hertz = lean.rotation = lean.rolling_constant = lean.rolling_spring = true;
  lean.cylinders = lean.moving_walls = true;
  if (lean.orientation == OrientationUpdate::none) lean.orientation = OrientationUpdate::exponential;
  lean.periodic = {true, true, true};
  if (lean.flow == FlowKind::none) lean.flow = FlowKind::uniform;
  if (lean.gravity == GravityKind::none) lean.gravity = GravityKind::constant;
  return lean;
}

namespace {

std::vector<std::string> memory_files(const BuildOptions& o) {
  if (!o.history) return {o.corrects() ? "touch.cl" : "history_none.cl"};
  if (o.corrects()) return {"history.cl", "onset_spring.cl"};
  return {"history.cl"};
}

std::vector<std::string> contact_files(const BuildOptions& o) {
  if (o.implicit_dashpots())
    return {"contact_point.cl", "stretch_held.cl", "dashpots_implicit.cl",
            "onset_none.cl",    "turn_none.cl",    "contact.cl"};
  if (!o.predicts())
    return {"contact_point.cl", "stretch_held.cl", "dashpots_explicit.cl", "refined_none.cl", "onset_none.cl",
            "turn_none.cl",     "contact.cl"};
  if (!o.corrects())
    return {"contact_point.cl", "stretch_middle.cl", "dashpots_explicit.cl",
            "refined_none.cl",  "onset_none.cl",     "turn_none.cl",
            "contact.cl"};
  return {"contact_point.cl",
          "stretch_middle.cl",
          "dashpots_explicit.cl",
          "onset_flow.cl",
          "onset_linear.cl",
          o.hertz ? "onset_hertz.cl" : "onset_by_linear.cl",
          o.ledger ? "onset_booked.cl" : "onset_unbooked.cl",
          "onset_before.cl",
          o.history ? "onset_bend.cl" : "onset_bend_none.cl",
          "onset_corrected.cl",
          o.history ? "turn_followed.cl" : "turn_none.cl",
          "contact.cl"};
}

/// How often forces are evaluated in a step, and for how long springs are stretched before.
std::vector<std::string> stage_files(const BuildOptions& o) {
  if (o.implicit_dashpots()) return {"stages_springs_first.cl"};
  if (o.integrator == Integrator::pefrl) return {"stages_composed.cl"};
  return {"stages_one.cl"};
}

std::vector<std::string> law_files(const BuildOptions& o) {
  const bool rolls = o.rolling_constant || o.rolling_spring;
  std::vector<std::string> files{o.ledger ? "ledger_kept.cl" : "ledger_none.cl",
                                 o.ledger ? "booking.cl" : "booking_none.cl",
                                 o.hertz ? "rise_hertz.cl" : "rise_none.cl",
                                 "linear_normal.cl",
                                 o.friction ? "friction_viscous.cl" : "friction_none.cl",
                                 o.cohesion ? "cohesion_linear.cl" : "cohesion_none.cl",
                                 o.rotation ? "rotation.cl" : "rotation_none.cl",
                                 o.corrects() ? "corrections_kept.cl" : "corrections_none.cl",
                                 "rolling_point.cl",
                                 o.rolling_constant ? "rolling_constant.cl" : "rolling_constant_none.cl",
                                 o.rolling_spring ? "rolling_spring.cl" : "rolling_spring_none.cl",
                                 o.keeps_rests() ? "rests_kept.cl" : "rests_none.cl",
                                 rolls ? "rolling.cl" : "rolling_none.cl",
                                 "turnover.cl"};
  for (const auto& part : {memory_files(o), contact_files(o)})
    files.insert(files.end(), part.begin(), part.end());
  if (!o.corrects() || !o.ledger) files.push_back("events_none.cl");
  return files;
}

std::vector<std::string> detector_files(const BuildOptions& o) {
  return {"spheres.cl",
          o.moving_walls ? "walls_moving.cl" : "walls_still.cl",
          "walls_common.cl",
          o.planes ? "planes.cl" : "planes_none.cl",
          o.rectangles ? "rectangles.cl" : "rectangles_none.cl",
          o.cylinders ? "cylinders.cl" : "cylinders_none.cl"};
}

std::vector<std::string> orientation_files(OrientationUpdate update) {
  switch (update) {
    case OrientationUpdate::none:
      return {"orientation_none.cl"};
    case OrientationUpdate::exponential:
      return {"quaternion.cl", "orientation_exponential.cl", "orientation_kept.cl"};
    case OrientationUpdate::forward_euler:
      return {"quaternion.cl", "orientation_forward_euler.cl", "orientation_kept.cl"};
  }
  return {};
}

std::vector<std::string> integrator_files(const BuildOptions& o) {
  if (o.implicit_dashpots())
    return {o.rotation ? "implicit_spin.cl" : "implicit_spin_none.cl", "velocity_verlet_implicit.cl",
            "complete_none.cl", "boundary_predicted.cl",
            o.rotation ? "boundary_spin_predicted.cl" : "boundary_spin_none.cl"};
  if (o.integrator == Integrator::pefrl)
    return {"pefrl.cl", "boundary.cl", o.rotation ? "boundary_spin.cl" : "boundary_spin_none.cl"};
  if (!o.predicts())
    return {std::string(name_of(o.integrator)) + ".cl", "complete_none.cl", "boundary.cl",
            o.rotation ? "boundary_spin.cl" : "boundary_spin_none.cl"};
  return {o.rotation ? "predicted_spin.cl" : "predicted_spin_none.cl", "velocity_verlet_predicted.cl",
          "complete_none.cl", "boundary_predicted.cl",
          o.rotation ? "boundary_spin_predicted.cl" : "boundary_spin_none.cl"};
}

std::string drag_file(const BuildOptions& o) {
  if (o.flow == FlowKind::none || o.integrator == Integrator::euler_trapezoid_implicit_drag)
    return "drag_by_integrator.cl";
  return o.implicit_dashpots() ? "drag_implicit.cl" : "drag_in_force.cl";
}

std::vector<std::string> motion_files(const BuildOptions& o) {
  std::vector<std::string> files{"forces.cl", "drift.cl"};
  for (const auto& part : {orientation_files(o.orientation), integrator_files(o)})
    files.insert(files.end(), part.begin(), part.end());
  return files;
}

}  // namespace

std::vector<std::string> kernel_files(const BuildOptions& o, bool pocl) {
  const std::vector<std::string> fields{file_of(o.gravity), file_of(o.flow), drag_file(o)};
  const std::vector<std::string> path =
      o.small ? std::vector<std::string>{"small.cl"}
              : std::vector<std::string>{"scan.cl", "sorting.cl", "zones.cl", "pairs.cl", "steps.cl"};
  std::vector<std::string> files = number_files(o.precision, pocl);
  files.push_back(velocity_file(o.precision));
  for (const auto& part : {stage_files(o), law_files(o), detector_files(o), fields, motion_files(o), path})
    files.insert(files.end(), part.begin(), part.end());
  if (o.remembers() && !o.small) files.push_back("carry.cl");
  if (o.implicit_dashpots() && !o.small) files.push_back("springs_first.cl");
  return files;
}

std::string definitions(const BuildOptions& o) {
  const auto flag = [](const char* name, bool on) { return std::string(" -D ") + name + (on ? "=1" : "=0"); };
  return flag("PERIODIC_X", o.periodic[0]) + flag("PERIODIC_Y", o.periodic[1]) +
         flag("PERIODIC_Z", o.periodic[2]) + flag("MANY_MATERIALS", o.many_materials);
}

}  // namespace grainproof::opencl
