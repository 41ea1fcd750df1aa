// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/watch.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "reference_cpu/bodies.hpp"
#include "reference_cpu/laws/pair_laws.hpp"

namespace grainproof::reference {
namespace {

/// A contact resolved by fewer steps than this is blamed on the step.
constexpr double few_steps_per_contact = 20.0;

struct Meeting {
  std::string who;
  double smaller_radius;
  double contact_time;
};

struct Reduced {
  double mass;
  double radius;
};

double contact_time(const Scene& scene, std::int32_t a, std::int32_t b, const Reduced& pair, double overlap) {
  const PairLaws laws = resolve(scene, a, b);
  return laws.hertz.present() ? laws.hertz.contact_time(std::sqrt(pair.radius * overlap), pair.mass)
                              : laws.normal.contact_time(pair.mass);
}

Meeting meeting(const Trouble& trouble, const Scene& scene) {
  const Bodies bodies = bodies_of(scene);
  const Body& one = bodies.body[trouble.particle];
  const std::int32_t material = bodies.material[trouble.particle];
  std::ostringstream who;
  if (trouble.kind == Trouble::Kind::wall_too_deep) {
    const Wall& wall = scene.walls[trouble.partner];
    who << "particle " << scene.particles[trouble.particle].id << " overlaps the wall '" << wall.name << "'";
    return {
        who.str(), one.radius,
        contact_time(scene, wall.material, material, {1.0 / one.inverse_mass, one.radius}, trouble.overlap)};
  }
  const Body& two = bodies.body[trouble.partner];
  who << "particles " << scene.particles[trouble.particle].id << " and "
      << scene.particles[trouble.partner].id << " overlap";
  const Reduced pair{1.0 / (one.inverse_mass + two.inverse_mass),
                     one.radius * two.radius / (one.radius + two.radius)};
  return {who.str(), std::min(one.radius, two.radius),
          contact_time(scene, material, bodies.material[trouble.partner], pair, trouble.overlap)};
}

std::string likely_reason(double step, double contact_time) {
  std::ostringstream text;
  const double share = step / contact_time;
  if (share * few_steps_per_contact > 1.0)
    text << "step too large for this stiffness: " << step << " s is " << share << " of the contact time "
         << contact_time << " s; take at most " << contact_time / few_steps_per_contact << " s";
  else
    text << "impact too fast or load too high for this stiffness; raise the stiffness (and shorten the step)";
  return text.str();
}

std::string too_deep(const Trouble& trouble, const Scene& scene, double limit) {
  const Meeting meet = meeting(trouble, scene);
  std::ostringstream text;
  text << meet.who << " by " << trouble.overlap << " m, " << trouble.overlap / meet.smaller_radius
       << " of the smaller radius where " << limit
       << " is allowed; likely cause: " << likely_reason(scene.run.step, meet.contact_time);
  return text.str();
}

std::string lost(const Trouble& trouble, const Scene& scene) {
  std::ostringstream text;
  text << "particle " << scene.particles[trouble.particle].id;
  if (trouble.kind == Trouble::Kind::not_finite)
    text
        << " has a position or velocity that is not a number; likely cause: step too large for the stiffness "
           "or drag, so that the motion grew without bound";
  else if (trouble.kind == Trouble::Kind::leapt)
    text << " moved by more than its radius in one step, and so may pass through what it should hit; likely "
            "cause: step too large for this speed, stiffness or force";
  else
    text
        << " left the domain through a face that is not periodic; likely cause: no wall there, or a step too "
           "large for the stiffness. Enlarge the domain, add a wall or shorten the step";
  return text.str();
}

std::vector<std::int64_t> ids_of(const Trouble& trouble, const Scene& scene) {
  std::vector<std::int64_t> ids{scene.particles[trouble.particle].id};
  if (trouble.kind == Trouble::Kind::pair_too_deep) ids.push_back(scene.particles[trouble.partner].id);
  return ids;
}

}  // namespace

RunWentWrong in_words(const Trouble& trouble, const Scene& scene, std::int64_t step, double overlap_limit) {
  const bool deep =
      trouble.kind == Trouble::Kind::pair_too_deep || trouble.kind == Trouble::Kind::wall_too_deep;
  const double time = static_cast<double>(step) * scene.run.step;
  return RunWentWrong(deep ? too_deep(trouble, scene, overlap_limit) : lost(trouble, scene), step, time,
                      ids_of(trouble, scene));
}

}  // namespace grainproof::reference
