// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/dense_options.hpp"

#include <algorithm>

#include "opencl/build_options.hpp"
#include "opencl/layout.hpp"
#include "opencl/near_walls.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

/// Walls are bits of a mask, kernels/dense_box.cl.
constexpr std::size_t most_planes = 30;
/// What the unit of force is made for: DenseImager::sum_unit.
constexpr double most_friction = 4.0;

bool predicts(const Scene& scene) {
  return scene.run.integrator == Integrator::velocity_verlet_predicted ||
         scene.run.integrator == Integrator::onset_corrected;
}

Support dynamics_supported(const Scene& scene, const Request& request) {
  if (request.ledger) return Support::no("the ledger is kept by the zoned path");
  if (!std::holds_alternative<ConstantGravity>(scene.gravity)) return Support::no("gravity is not constant");
  if (!std::holds_alternative<NoFlow>(scene.flow)) return Support::no("there is a fluid");
  if (scene.orientation != OrientationUpdate::none) return Support::no("orientations are asked for");
  if (!scene.remembered.empty()) return Support::no("contacts remember something at the start");
  if (!predicts(scene) && scene.run.integrator != Integrator::velocity_verlet &&
      scene.run.integrator != Integrator::leapfrog_verlet)
    return Support::no("the integrator is not of Verlet's kind");
  return {};
}

Support contact_supported(const Scene& scene, std::size_t a, std::size_t b) {
  const ContactLaws& laws = scene.contacts.at(a, b);
  if (!std::holds_alternative<LinearNormal>(laws.normal)) return Support::no("a contact is not linear");
  if (!std::holds_alternative<NoCohesion>(laws.cohesion)) return Support::no("there is cohesion");
  if (!std::holds_alternative<NoRolling>(laws.rolling)) return Support::no("there is rolling resistance");
  const PairCoefficients c = coefficients_of(scene, a, b);
  if (std::max(c.friction, c.history.coefficient) > most_friction)
    return Support::no(
        "a coefficient of friction is above 4, for which sums in canonical order have no room");
  return {};
}

Support walls_supported(const Scene& scene) {
  if (scene.walls.size() > most_planes) return Support::no("there are more than 30 walls");
  for (const Wall& wall : scene.walls) {
    const auto* plane = std::get_if<Plane>(&wall.shape);
    if (plane == nullptr || !std::holds_alternative<Still>(wall.motion))
      return Support::no("wall " + wall.name + " is not a plane at rest");
    for (int axis = 0; axis < 3; ++axis)
      if (scene.domain.periodic(axis) && plane->normal[axis] != 0.0)
        return Support::no("wall " + wall.name + " is not parallel to a periodic axis");
  }
  return {};
}

Support box_supported(const Scene& scene, double skin) {
  const double reach = 2.0 * (largest_reach(scene) + std::max(skin, 0.6 * largest_reach(scene)));
  for (int axis = 0; axis < 3; ++axis)
    if (scene.domain.periodic(axis) && scene.domain.extent()[axis] < 2.5 * reach)
      return Support::no("the box is periodic and shorter than five reaches of a list");
  return {};
}

}  // namespace

Support dense_support(const Scene& scene, const Request& request, double skin, bool one) {
  if (scene.particles.empty()) return Support::no("there are no particles");
  // Who was in touch is kept as bits of the particles of a work-item.
  if (one && scene.run.integrator == Integrator::onset_corrected)
    return Support::no("onset_corrected needs many particles a work-item");
  if (const Support s = dynamics_supported(scene, request); !s) return s;
  const auto material = static_cast<std::size_t>(scene.particles.front().material);
  double smallest = scene.particles.front().diameter, largest = smallest;
  for (const Particle& p : scene.particles) {
    if (static_cast<std::size_t>(p.material) != material)
      return Support::no("particles are of more than one material");
    smallest = std::min(smallest, p.diameter);
    largest = std::max(largest, p.diameter);
  }
  if (largest > 4.0 * smallest) return Support::no("diameters differ by more than a factor of four");
  if (const Support s = walls_supported(scene); !s) return s;
  if (const Support s = contact_supported(scene, material, material); !s) return s;
  for (const Wall& wall : scene.walls)
    if (const Support s = contact_supported(scene, material, static_cast<std::size_t>(wall.material)); !s)
      return s;
  return box_supported(scene, skin);
}

DenseOptions dense_options(const Scene& scene, Precision precision, bool one) {
  const Particle& any = scene.particles.front();
  const auto material = static_cast<std::size_t>(any.material);
  const auto pair = coefficients_of(scene, material, material);
  DenseOptions o;
  o.precision = precision;
  o.one = one;
  o.rotation = scene.rotation;
  o.canonical = scene.run.order == SumOrder::canonical;
  const NearWalls near = near_walls(scene);
  o.planes = !near.planes.empty();
  std::vector<PairCoefficients> laws{pair};
  for (const auto& wall : near.planes)
    laws.push_back(coefficients_of(scene, material, static_cast<std::size_t>(wall.material)));
  for (const PairCoefficients& law : laws) {
    o.friction |= law.friction > 0.0;
    o.history |= law.history.coefficient > 0.0;
  }
  if (pair.history.coefficient > 0.0)
    o.history_variant = remembers | (pair.history.limit == CoulombLimit::spring ? limit_on_spring : 0) |
                        (pair.history.arm == TorqueArm::overlap ? arm_shortened : 0) |
                        (pair.history.turn == SpringTurn::project ? turn_projects : 0);
  o.predicted = predicts(scene);
  o.corrected = scene.run.integrator == Integrator::onset_corrected;
  o.varied = std::any_of(scene.particles.begin(), scene.particles.end(),
                         [&](const Particle& p) { return p.fixed || p.diameter != any.diameter; });
  return o;
}

std::vector<std::string> dense_kernel_files(const DenseOptions& o, bool pocl) {
  const bool twice = o.precision == Precision::double_precision;
  std::vector<std::string> files = number_files(o.precision, pocl);
  const auto add = [&](std::initializer_list<const char*> more) {
    files.insert(files.end(), more.begin(), more.end());
  };
  add({"scan.cl", "sorting.cl"});
  if (o.one)
    add({twice ? "wide_double_1.cl" : "wide_single_1.cl", "wide_1.cl"});
  else
    add({twice ? "wide_double_8.cl" : "wide_single_16.cl"});
  add({"dense_roots.cl", "dense_box.cl", o.canonical ? "dense_sum_canonical.cl" : "dense_sum_fast.cl",
       "dense_contact.cl"});
  if (o.corrected)
    add({"dense_flow.cl", "dense_before.cl", "dense_bend.cl", "dense_slide.cl", "dense_onset.cl"});
  else
    add({"dense_onset_none.cl"});
  add({"dense_hold.cl", "dense_springs.cl", "dense_pairs.cl", "dense_walls.cl",
       o.one ? "dense_shares_none.cl" : "dense_shares.cl", "dense_step.cl", "dense_order.cl", "dense_near.cl",
       "dense_pack.cl"});
  if (o.one)
    add({"dense_list_each.cl"});
  else
    add({"dense_seek.cl", "dense_list.cl"});
  return files;
}

std::string dense_definitions(const DenseOptions& o) {
  const auto set = [](const char* name, int value) {
    return std::string(" -D ") + name + "=" + std::to_string(value);
  };
  return set("PERIODIC_X", 0) + set("PERIODIC_Y", 0) + set("PERIODIC_Z", 0) + set("MANY_MATERIALS", 0) +
         set("FRICTION", o.friction) + set("HISTORY", o.history) + set("ROTATION", o.rotation) +
         set("PLANES", o.planes) + set("VARIED", o.varied) + set("HISTORY_VARIANT", o.history_variant) +
         set("PREDICTED", o.predicted) + set("CORRECTED", o.corrected) + set("QUARTERS", quarters_of(o)) +
         set("MOST_PARTNERS", o.most_partners) + set("WINDOW", window_size);
}

}  // namespace grainproof::opencl
