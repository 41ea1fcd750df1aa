// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/long_verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analytic/measured_errors.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

constexpr double quantum = 0x1p-30;   // of the longest side, docs/precision.md
constexpr double deviations = 4.0;    // of a mean, that chance may make
constexpr double settled_from = 0.2;  // of a run of the shaken bed, which starts on a lattice

bool gains_without_end(const std::string& scene, Integrator integrator) {
  return scene == "bounces" && (integrator == Integrator::euler_trapezoid ||
                                integrator == Integrator::euler_trapezoid_implicit_drag);
}

/// Of the relative speed, by one elastic bounce; by a power law between the steps that were measured.
double error_of_a_bounce(Integrator integrator, double steps_a_contact) {
  using analytic::measured_at;
  const auto rows = analytic::measured_errors();
  const auto row = std::ranges::find_if(rows, [&](const analytic::MeasuredErrors& one) {
    return one.law == analytic::ErrorLaw::linear && one.integrator == integrator && one.restitution == 1.0;
  });
  if (row == rows.end()) throw EngineFailed("no errors of a single bounce are known of this integrator");
  std::size_t i = 1;
  while (i + 1 < measured_at.size() && measured_at[i] < steps_a_contact) ++i;
  const double order =
      std::log(row->error[i - 1] / row->error[i]) / std::log(measured_at[i] / measured_at[i - 1]);
  return row->error[i] * std::pow(measured_at[i] / steps_a_contact, order);
}

/// What is shown as a drift in each window.
using Drift = double (*)(const LongPlan& plan, const Seen& start, const Window& window);

LongVerdict drift_within(const LongPlan& plan, const LongHistory& history, Drift drift, double bound,
                         std::string because) {
  const Seen start = seen(plan, first_frame(plan.scene));
  LongVerdict verdict{0.0, bound, false, std::move(because)};
  for (const Window& window : history.windows) {
    const double now = drift(plan, start, window);
    verdict.measured = std::max(verdict.measured, now);
    verdict.curve.emplace_back(window.step, now);
  }
  verdict.held = verdict.measured <= bound;
  return verdict;
}

/// The largest of a window; a drift that fell back would not be one.
template <Look look>
double most(const LongPlan&, const Seen&, const Window& window) {
  return at(window.most, look);
}

double energy_drift(const LongPlan&, const Seen& start, const Window& window) {
  return std::abs(at(window.most, Look::energy) / at(start, Look::energy) - 1.0);
}

double momentum_share(const LongPlan& plan, const Seen&, const Window& window) {
  return at(window.most, Look::momentum) / plan.unit_speed;
}

double way_in_diameters(const LongPlan& plan, const Seen&, const Window& window) {
  return at(window.most, Look::position) / plan.scene.particles.front().diameter;
}

double overlap_drift(const LongPlan& plan, const Seen&, const Window& window) {
  return std::abs(at(window.most, Look::overlap) / plan.unit_overlap - 1.0);
}

/// A bounce of a symplectic scheme changes the energy by about 2√2 `one` times the sine of the phase of its
/// step, and the energy the phase of the next: the standard map. Below its critical 0.97 no energy leaves the
/// resonance that it is in, whose width is 4 sqrt(K). Of the energy.
double resonance_of(const LongPlan& plan, double one) {
  const double flight = steps_a_bounce(plan) - plan.contact_s / plan.scene.run.step;
  const double phase = std::numbers::pi * flight;  // that a bounce gains for a change of the energy by itself
  const double kick = phase * 2.0 * std::numbers::sqrt2 * one;
  if (kick > 0.97) throw EngineFailed("the step is too long for energies to be bound to a resonance");
  return 4.0 * std::sqrt(kick) / phase;
}

LongVerdict judge_bounces(const LongPlan& plan, const LongHistory& history, const std::string& quantity,
                          double u) {
  const double steps = plan.contact_s / plan.scene.run.step, count = static_cast<double>(plan.steps);
  const double number = count / steps_a_bounce(plan);
  const double one = error_of_a_bounce(plan.scene.run.integrator, steps);
  const bool symplectic = plan.scene.run.integrator == Integrator::velocity_verlet ||
                          plan.scene.run.integrator == Integrator::leapfrog_verlet;
  const double walk = deviations * u * std::sqrt(count);
  const double method = symplectic ? resonance_of(plan, one) : deviations * 2.0 * one * std::sqrt(number);
  const double sampled = 1.0 - std::cos(0.5 * std::numbers::pi / steps);
  if (quantity == "energy")
    return drift_within(plan, history, energy_drift, method + walk,
                        symplectic
                            ? "symplectic: what bounces are wrong by stays within the widest resonance "
                              "with the step; rounding walks"
                            : "errors of a bounce at random phases walk, as rounding does");
  if (quantity == "momentum")
    return drift_within(plan, history, momentum_share, walk,
                        "every force has its counter-force; the rounding of each step walks");
  if (quantity == "position")
    return drift_within(plan, history, way_in_diameters,
                        walk * plan.unit_speed * plan.scene.run.step * count / std::numbers::sqrt3 /
                            plan.scene.particles.front().diameter,
                        "what the bound of the momentum comes to over the run");
  return drift_within(plan, history, overlap_drift, 0.5 * method + walk + sampled,
                      "half of the energy's, and that steps pass the deepest point by");
}

/// The source's scheme multiplies the speed of an undamped bounce by exp(π² h/4 t_c) (integrators.6); it is
/// lost when the overlap has grown to the limit.
LongVerdict judge_the_end(const LongPlan& plan, const LongHistory& history) {
  const double a_contact = plan.contact_s / plan.scene.run.step;
  const double factor = std::exp(0.25 * std::pow(std::numbers::pi, 2) / a_contact);
  const double limit = plan.scene.run.overlap_limit * 0.5 *
                       std::ranges::min(plan.scene.particles, {}, &Particle::diameter).diameter;
  const double flight = steps_a_bounce(plan) - a_contact;
  double expected = 0.5 * flight, overlap = plan.unit_overlap;
  // The deepest point is half a contact in, when half of a bounce's gain is made.
  for (double speed = 1.0; overlap * std::sqrt(factor) < limit; overlap *= factor) {
    speed *= factor;
    expected += a_contact + flight / speed;
  }
  const auto measured = static_cast<double>(history.failed_at);
  return {measured, expected, !history.failed.empty() && std::abs(measured / expected - 1.0) < 0.15,
          "every undamped contact gains energy (integrators.7): the step at which the overlap is too deep, "
          "within 15 %"};
}

LongVerdict judge_pile(const LongPlan& plan, const LongHistory& history, const std::string& quantity,
                       double u) {
  const Scene& scene = plan.scene;
  const double h = scene.run.step, d = scene.particles.front().diameter;
  const double weight = std::pow(plan.unit_speed, 2) / d;
  // The last digit of a place: of a coordinate, or of what is left of a quantum (docs/precision.md).
  const double longest = scene.domain.extent().maxCoeff();
  const double digit = u > 1e-10 ? longest * quantum * u : longest * u;
  const double speed = 8.0 * (digit / h + 16.0 * u * weight * plan.contact_s);
  const double way = (64.0 * digit + 1000.0 * u * plan.unit_overlap) / d;
  const auto bodies = static_cast<double>(scene.particles.size());
  const double energy_at_start = at(seen(plan, first_frame(scene)), Look::energy);
  const double lightest_share =
      2000.0 * std::numbers::pi / 6.0 * std::pow(d, 3) * weight * d / energy_at_start;
  if (quantity == "speed")
    return drift_within(plan, history, most<Look::speed>, speed,
                        "eight times a last digit of the place a step, and what rounding of contacts' forces "
                        "gives in a contact time, m/s");
  if (quantity == "momentum")
    return drift_within(plan, history, most<Look::momentum>, speed, "no more than the speed's, m/s");
  if (quantity == "position")
    return drift_within(plan, history, way_in_diameters, way,
                        "springs hold it: digits of the place, and a thousand roundings of the overlap");
  if (quantity == "energy")
    return drift_within(plan, history, energy_drift, 10.0 * bodies * way * lightest_share + bodies * u,
                        "ten weights a body over the way, and rounding of the sum");
  return drift_within(plan, history, overlap_drift, 2.0 * way * d / plan.unit_overlap, "twice the way");
}

struct Half {
  double mean, error;
};

/// Of the mean, as if blocks of neighbours were independent of one another.
double error_in_blocks(const std::vector<double>& values, std::size_t from, std::size_t blocks,
                       std::size_t block) {
  std::vector<double> means(blocks, 0.0);
  for (std::size_t i = 0; i < blocks * block; ++i)
    means[i / block] += values[from + i] / static_cast<double>(block);
  const auto count = static_cast<double>(blocks);
  double mean = 0.0, squares = 0.0;
  for (double one : means) mean += one / count;
  for (double one : means) squares += std::pow(one - mean, 2);
  return std::sqrt(squares / std::max(1.0, count - 1.0) / count);
}

/// A bed remembers for longer than a window, so windows that follow one another are alike, and their scatter
/// says too little of the mean. Blocks are taken larger and larger, the largest error counts (Flyvbjerg and
/// Petersen, J. Chem. Phys. 91, 1989), and there are never so few that chance hides it.
Half half_of(const std::vector<double>& values, std::size_t from, std::size_t to) {
  constexpr std::size_t fewest_blocks = 6;
  const std::size_t count = to - from;
  Half half{0.0, error_in_blocks(values, from, count, 1)};
  for (std::size_t i = from; i < to; ++i) half.mean += values[i] / static_cast<double>(count);
  for (std::size_t block = 2; count / block >= fewest_blocks; block *= 2)
    half.error = std::max(half.error, error_in_blocks(values, from, count / block, block));
  return half;
}

/// The means of both halves, once the start is forgotten: apart by chance only.
LongVerdict halves_agree(const LongHistory& history, Look look, double unit) {
  constexpr double leeway = 0.02;
  LongVerdict verdict{
      .because =
          "both halves alike: four standard errors of their means, from blocks of windows, and a fiftieth"};
  std::vector<double> values;
  for (const Window& window : history.windows) {
    values.push_back(at(window.mean, look));
    verdict.curve.emplace_back(window.step, at(window.mean, look) / unit);
  }
  const auto from = static_cast<std::size_t>(settled_from * static_cast<double>(values.size()) + 0.999);
  const std::size_t middle = from + (values.size() - from) / 2;
  const Half one = half_of(values, from, middle), other = half_of(values, middle, values.size());
  const double scale = std::abs(one.mean);
  verdict.measured = std::abs(other.mean - one.mean) / scale;
  verdict.bound = deviations * std::hypot(one.error, other.error) / scale + leeway;
  verdict.held = verdict.measured <= verdict.bound;
  return verdict;
}

/// A crowd in which bodies go every way for themselves goes along the floor no faster than chance lets it.
LongVerdict stays_put(const LongPlan& plan, const LongHistory& history) {
  double energy = 0.0, mass = 0.0;
  for (const Window& window : history.windows)
    energy += at(window.mean, Look::energy) / static_cast<double>(history.windows.size());
  for (const Particle& particle : plan.scene.particles)
    mass += plan.scene.materials[particle.material].density * std::numbers::pi / 6.0 *
            std::pow(particle.diameter, 3);
  const double bodies = static_cast<double>(plan.scene.particles.size());
  return drift_within(
      plan, history,
      [](const LongPlan& p, const Seen&, const Window& w) {
        return std::abs(at(w.mean, Look::momentum)) / p.unit_speed;
      },
      deviations * std::sqrt(2.0 * energy / mass / bodies) / plan.unit_speed,
      "no window along the floor faster than four times the rms speed over the root of the bodies, in sqrt(g "
      "d)");
}

LongVerdict judge_vibrated(const LongPlan& plan, const LongHistory& history, const std::string& quantity) {
  constexpr double deepest = 0.1;
  if (quantity == "lost")
    return drift_within(plan, history, most<Look::lost>, 0.0, "every body stays in the box");
  if (quantity == "deepest")
    return drift_within(
        plan, history,
        [](const LongPlan& p, const Seen&, const Window& w) {
          return at(w.most, Look::overlap) / p.unit_overlap;
        },
        deepest, "impacts at a few times the floor's speed overlap by less than a tenth of a diameter");
  if (quantity == "energy") return halves_agree(history, Look::energy, 1.0);
  if (quantity == "overlap") return halves_agree(history, Look::overlap, plan.unit_overlap);
  if (quantity == "position") return halves_agree(history, Look::position, plan.unit_overlap);
  return stays_put(plan, history);
}

}  // namespace

std::vector<std::string> long_quantities(const std::string& scene, Integrator integrator) {
  if (gains_without_end(scene, integrator)) return {"end"};
  if (scene == "bounces") return {"energy", "momentum", "position", "overlap"};
  if (scene == "pile") return {"speed", "energy", "momentum", "position", "overlap"};
  return {"lost", "deepest", "energy", "momentum", "position", "overlap"};
}

LongVerdict long_verdict(const LongPlan& plan, const LongHistory& history, const std::string& quantity,
                         double unit_roundoff) {
  if (quantity == "end") return judge_the_end(plan, history);
  if (!history.failed.empty())
    throw EngineFailed("went wrong at step " + std::to_string(history.failed_at) + ": " + history.failed);
  if (plan.name == "bounces") return judge_bounces(plan, history, quantity, unit_roundoff);
  if (plan.name == "pile") return judge_pile(plan, history, quantity, unit_roundoff);
  return judge_vibrated(plan, history, quantity);
}

}  // namespace grainproof::bench
