// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/stable_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "benchmarks/common/stability_cases.hpp"
#include "input/uniform.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

/// How small a perturbation an engine can tell from rounding, as a share of what opens a contact; grown by
/// 1e4 it must still keep every contact, and its friction below the Coulomb limit.
struct Finesse {
  double share;
  double growing_share;
  double from, to;  ///< ln of the growth over which a rate is measured: the later, the purer is its motion
};

/// Single and mixed precision have to move a body by more than a quantum of its positions, unless the motion
/// grows anyway; with friction they need not, and the Coulomb limit is near.
Finesse finesse_of(const SteppingEngine& engine, const Scene& scene) {
  if (engine.provenance().precision == "double") return {1e-7, 1e-10, 13.0, 20.0};
  return {scene.rotation ? 1e-5 : 1e-4, 1e-7, 11.0, 14.5};
}

constexpr double bound = 1e4;  // of the kinetic energy
constexpr double least_contact_times = 200.0;
constexpr double seen_above = 1.005;  // of the predicted limit
constexpr double farthest = 16.0;     // from it that a limit is looked for, as a factor
constexpr double patience = 2.0;      // of the most steps, that a growth may ask for and still be waited for
constexpr double fineness = 2.5e-3;   // of a step that is not where it was predicted
constexpr int blocks = 64;            // after which a run that has grown ends
/// In each: what grows until it slips changes its sign every step from then on, and at a boundary, between
/// two signs, nothing is left to be seen of it.
constexpr int looks_a_block = 8;

double mass_of(const Scene& scene, const Particle& particle) {
  return scene.materials[particle.material].density * std::numbers::pi / 6.0 * std::pow(particle.diameter, 3);
}

double kinetic_energy(const Scene& scene, const Frame& frame) {
  double energy = 0.0;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const double mass = mass_of(scene, scene.particles[i]);
    energy += 0.5 * mass * frame.velocity[i].squaredNorm();
    if (scene.rotation)
      energy +=
          0.05 * mass * std::pow(scene.particles[i].diameter, 2) * frame.angular_velocity[i].squaredNorm();
  }
  return energy;
}

/// Of the steps after step `done`, `every` so many: written down by a device on its way.
std::vector<Frame> next_frames(Run& run, std::int64_t done, std::int64_t count, std::int64_t every) {
  std::vector<std::int64_t> steps;
  for (std::int64_t n = 1; n <= count; ++n) steps.push_back(done + n * every);
  std::vector<Frame> frames;
  run.record(steps, frames);
  return frames;
}

bool stays_bounded(SteppingEngine& engine, Scene scene, double step, double contact_times) {
  scene.run.step = step;
  const auto steps = static_cast<std::int64_t>(std::ceil(contact_times * contact_time_of(scene) / step));
  const std::int64_t every = std::max<std::int64_t>(1, steps / (blocks * looks_a_block));
  try {
    const auto run = engine.start(scene, {});
    const double start = kinetic_energy(scene, run->frame());
    for (std::int64_t done = 0; done < steps; done += looks_a_block * every)
      for (const Frame& frame : next_frames(*run, done, looks_a_block, every))
        if (!(kinetic_energy(scene, frame) <= bound * start)) return false;
  } catch (const RunWentWrong&) {
    return false;
  }
  return true;
}

/// How long a run must be to see what grows at `width` times the predicted limit, in steps.
double steps_to_see(const Prediction& prediction, double width) {
  const double a_step = std::log(prediction.growth(width * prediction.limit()));
  return a_step > 0.0 ? 1.3 * 0.5 * std::log(bound) / a_step : std::numeric_limits<double>::infinity();
}

/// Half a percent above the predicted limit, or more where the motion that grows there would take far longer
/// than `most_steps` to be seen.
double width_to_see(const Prediction& prediction, double most_steps) {
  double above = seen_above - 1.0;
  while (steps_to_see(prediction, 1.0 + above) > patience * most_steps && 1.0 + above < farthest)
    above *= 1.5;
  return 1.0 + above;
}

analytic::Prestress prestress_of(const Scene& scene) {
  // Elsewhere attraction balances every contact, or it is one with a wall.
  return scene.title.starts_with("random") ? analytic::Prestress::kept : analytic::Prestress::left_out;
}

/// friction.2: one variant's static branch is the stronger the longer the step is.
bool holds_the_step(const Scene& scene) {
  return std::holds_alternative<StepFriction>(scene.contacts.at(0, 0).friction);
}

}  // namespace

Prediction::Prediction(const Scene& scene, std::string_view integrator)
    : scene_(scene),
      scheme_(analytic::linear_scheme(integrator)),
      by_step_(scheme_.weakens != analytic::Weakening::none || holds_the_step(scene)),
      parts_(parts(0.0)) {
  limit_ = by_step_
               ? analytic::spectral_limit(
                     scheme_, [this](double step) { return parts(step); }, analytic::undamped_limit(parts_))
               : analytic::spectral_limit(scheme_, parts_);
}

std::vector<analytic::LinearSystem> Prediction::parts(double step) const {
  std::vector<analytic::LinearSystem> bound;
  for (const analytic::LinearSystem& part : analytic::symmetric_parts(
           scene_, analytic::linearised(scene_, prestress_of(scene_), {scheme_.weakens, step})))
    bound.push_back(analytic::without_free_motions(part));
  return bound;
}

double Prediction::growth(double step) const {
  return analytic::growth_a_step(scheme_, by_step_ ? parts(step) : parts_, step);
}

Scene perturbed(const Scene& scene, double size) {
  Scene moved = scene;
  input::Uniform uniform(11);
  double lightest = std::numeric_limits<double>::infinity(), heavy = 0.0;
  for (const Particle& particle : scene.particles) lightest = std::min(lightest, mass_of(scene, particle));
  const double rate = std::numbers::pi / contact_time_of(scene);
  Vec3 momentum = Vec3::Zero();
  for (Particle& particle : moved.particles) {
    const double mass = mass_of(scene, particle);
    const double speed = size * rate * std::sqrt(lightest / mass);
    particle.position += size * uniform.in_cube();
    particle.velocity = speed * uniform.in_cube();
    if (scene.rotation) particle.angular_velocity = 2.0 * speed / particle.diameter * uniform.in_cube();
    momentum += mass * particle.velocity;
    heavy += mass;
  }
  if (scene.walls.empty())
    for (Particle& particle : moved.particles) particle.velocity -= momentum / heavy;
  return moved;
}

double MeasuredLimit::farthest_from(double predicted) const {
  return std::max(std::abs(stable / predicted - 1.0), std::abs(unstable / predicted - 1.0));
}

MeasuredLimit measured_limit(SteppingEngine& engine, const Scene& scene, const Prediction& prediction,
                             std::int64_t most_steps) {
  const Scene start = perturbed(scene, finesse_of(engine, scene).share * least_slack(scene));
  const auto most = static_cast<double>(most_steps);
  const double predicted = prediction.limit();
  double width = width_to_see(prediction, most), low = predicted / seen_above, high = predicted * width;
  const double contact_times = std::max(
      least_contact_times, std::min(steps_to_see(prediction, width), most) * high / contact_time_of(scene));
  int runs = 0;
  const auto stable = [&](double step) {
    ++runs;
    return stays_bounded(engine, start, step, contact_times);
  };
  const auto widen = [&] {
    if ((width *= width) > farthest)
      throw EngineFailed("no limit within a factor of 16 of the predicted one");
    return width;
  };
  if (stable(low)) {
    for (; stable(high); high = predicted * widen()) low = high;
  } else {
    do {
      high = low;
      low = predicted / widen();
    } while (!stable(low));
  }
  const bool as_predicted = low < predicted && predicted < high;
  while (!as_predicted && high - low > fineness * low) {
    const double middle = 0.5 * (low + high);
    (stable(middle) ? low : high) = middle;
  }
  return {low, high, contact_times, runs};
}

double measured_growth(SteppingEngine& engine, const Scene& scene, double step, double predicted_growth) {
  const Finesse finesse = finesse_of(engine, scene);
  Scene start = perturbed(scene, finesse.growing_share * least_slack(scene));
  start.run.step = step;
  const auto run = engine.start(start, {});
  const double initial = kinetic_energy(start, run->frame());
  // The largest energy of every half contact time, so that no phase of a swing counts.
  const auto window =
      std::max<std::int64_t>(2, static_cast<std::int64_t>(std::ceil(contact_time_of(scene) / step)));
  const auto most = static_cast<std::int64_t>(100.0 / predicted_growth);
  double first_steps = -1.0, first = 0.0;
  for (std::int64_t done = 0; done < most;) {
    double peak = 0.0;
    std::int64_t at = done;
    for (const Frame& frame : next_frames(*run, done, window, 1)) {
      const double energy = kinetic_energy(start, frame);
      ++done;
      if (energy > peak) {
        peak = energy;
        at = done;
      }
    }
    const double grown = 0.5 * std::log(peak / initial);
    if (first_steps < 0.0 && grown > finesse.from) {
      first_steps = static_cast<double>(at);
      first = grown;
    } else if (grown > finesse.to) {
      return (grown - first) / (static_cast<double>(at) - first_steps);
    }
  }
  throw EngineFailed("nothing grew as it should in five times the predicted number of steps");
}

}  // namespace grainproof::bench
