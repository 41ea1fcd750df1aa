// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/known_errors.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "benchmarks/common/pair_gas.hpp"
#include "benchmarks/common/scenes.hpp"
#include "model/errors.hpp"

namespace grainproof::bench {
namespace {

using enum KnownQuantity;

// LIGGGHTS 3.8.0 and LAMMPS 29Sep2021, which agree to every printed digit; three digits were kept.
constexpr std::array table{
    KnownError{1.0, rebound, 20, 2.5e-4},        KnownError{1.0, rebound, 50, 1.6e-5},
    KnownError{1.0, rebound, 100, 2.0e-6},       KnownError{1.0, rebound, 200, 2.5e-7},
    KnownError{1.0, rebound, 1000, 2.0e-9},      KnownError{0.9, rebound, 20, 1.06e-2},
    KnownError{0.9, rebound, 50, 3.99e-3},       KnownError{0.9, rebound, 100, 1.97e-3},
    KnownError{0.9, rebound, 200, 9.8e-4},       KnownError{0.9, rebound, 1000, 1.94e-4},
    KnownError{0.9, peak_overlap, 20, 4.9e-3},   KnownError{0.9, peak_overlap, 50, 1.1e-3},
    KnownError{0.9, peak_overlap, 100, 6.2e-4},  KnownError{0.9, peak_overlap, 200, 2.8e-4},
    KnownError{0.9, peak_overlap, 1000, 5.1e-5}, KnownError{0.5, rebound, 20, 3.75e-2},
    KnownError{0.5, rebound, 50, 1.41e-2},       KnownError{0.5, rebound, 100, 6.9e-3},
    KnownError{0.5, rebound, 200, 3.4e-3},       KnownError{0.5, rebound, 1000, 6.8e-4},
};

constexpr double approach = 1.0;  // m/s

double pair_mass() {
  return 0.5 * density * std::numbers::pi / 6.0 * std::pow(diameter, 3);
}

/// The surfaces are a millionth of a step's way apart at the start: the contact begins with the first step.
Scene head_on(const KnownError& known) {
  Scene scene = empty_scene(Vec3::Constant(8.0 * diameter));
  scene.domain.boundary = {Boundary::open, Boundary::open, Boundary::open};
  scene.rotation = false;
  scene.contacts.set(0, 0, ContactLaws{LinearNormal{stiffness, Restitution{known.restitution}}});
  const double contact = contact_time(pair_mass(), known.restitution);
  scene.run.step = contact / known.steps_per_contact;
  scene.run.end = 1.5 * contact;
  scene.run.sample_times = {0.0, scene.run.end};
  const double apart = diameter + 1e-6 * approach * scene.run.step;
  for (const double side : {-1.0, 1.0})
    scene.particles.push_back({side < 0.0 ? 1 : 2, 0, false, diameter, diameter,
                               Vec3::Constant(4.0 * diameter) + 0.5 * side * apart * Vec3::UnitX(),
                               -0.5 * side * approach * Vec3::UnitX()});
  return scene;
}

double peak_overlap_seen(const Observations& seen) {
  double deepest = 0.0;
  for (const Frame& frame : seen.frames)
    deepest = std::max(deepest, diameter - (frame.position.at(1) - frame.position.at(0)).norm());
  return deepest;
}

/// u/ω_d exp(−γ t) sin ω_d t where tan ω_d t = ω_d/γ, γ = η/(2 m).
double exact_peak_overlap(double of_restitution) {
  const double omega = std::numbers::pi / contact_time(pair_mass(), of_restitution);
  const double rate = -std::log(of_restitution) * omega / std::numbers::pi;
  const double time = std::atan2(omega, rate) / omega;
  return approach / omega * std::exp(-rate * time) * std::sin(omega * time);
}

}  // namespace

std::span<const KnownError> known_errors() {
  return table;
}

std::string_view name_of(KnownQuantity quantity) {
  return quantity == rebound ? "rebound" : "peak_overlap";
}

double error_now(Engine& engine, const KnownError& known) {
  const Scene scene = head_on(known);
  Request request;
  request.every_step = known.quantity == peak_overlap;
  const Observations seen = engine.observe(scene, request);
  if (seen.outcome.status != Outcome::Status::completed) throw EngineFailed(seen.outcome.reason);
  if (known.quantity == peak_overlap)
    return std::abs(peak_overlap_seen(seen) / exact_peak_overlap(known.restitution) - 1.0);
  const Frame& last = seen.frames.back();
  const double leaving = (last.velocity.at(1) - last.velocity.at(0)).x();
  return std::abs(leaving / (known.restitution * approach) - 1.0);
}

}  // namespace grainproof::bench
