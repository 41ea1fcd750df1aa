// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/quantity.hpp"

#include <array>
#include <cmath>
#include <string>

#include "comparisons/metrics/bed.hpp"
#include "comparisons/metrics/collision.hpp"
#include "comparisons/metrics/curves.hpp"
#include "comparisons/metrics/invariants.hpp"
#include "comparisons/metrics/resting.hpp"

namespace grainproof {
namespace {

using Derivation = Measured (*)(const Scene&, const Observations&);

/// What the exact side says by name, or else what its frames say.
template <Derivation derive>
Measured scalar(const char* name, const Scene& scene, const Observations& seen, const Observations& exact,
                double zero_scale = 0.0) {
  const auto told = exact.scalars.find(name);
  if (told == exact.scalars.end() && exact.frames.empty())
    return Measured::none(std::string("the exact solution does not say \"") + name + "\"");
  const Measured right = told != exact.scalars.end() ? Measured::of(told->second) : derive(scene, exact);
  return relative_error(derive(scene, seen), right, zero_scale);
}

using S = Scene;
using O = Observations;

constexpr bool every_step = true;
constexpr bool ledger = true;
constexpr bool curve = true;
constexpr bool no = false;

const std::array table{
    Quantity{"position", "the longest path of a particle", no, no, curve, position_error},
    Quantity{"velocity", "the largest exact speed", no, no, curve, velocity_error},
    Quantity{"angular_velocity", "the largest exact spin, or speed over radius where nothing turns", no, no,
             curve, angular_velocity_error},
    Quantity{"kinetic_energy", "its largest exact value", no, no, curve, kinetic_energy_error},
    Quantity{"restitution", "the exact value; the approach speed where that is zero", no, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<restitution>("restitution", s, seen, exact, 1.0);
             }},
    Quantity{"tangential_velocity_change", "the exact value", no, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<tangential_velocity_change>("tangential_velocity_change", s, seen, exact);
             }},
    Quantity{"contact_duration", "the exact value", every_step, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<contact_duration>("contact_duration", s, seen, exact);
             }},
    Quantity{"peak_overlap", "the exact value", every_step, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<peak_overlap>("peak_overlap", s, seen, exact);
             }},
    Quantity{"resting_overlap", "the exact value", no, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<resting_overlap>("resting_overlap", s, seen, exact);
             }},
    Quantity{"stop_time", "the exact value", every_step, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<stop_time>("stop_time", s, seen, exact);
             }},
    Quantity{"stop_distance", "the exact value", no, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<stop_distance>("stop_distance", s, seen, exact);
             }},
    Quantity{"bed_height", "the exact value", no, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<bed_height>("bed_height", s, seen, exact);
             }},
    Quantity{"contact_number", "the exact value", no, no, no,
             [](const S& s, const O& seen, const O& exact) {
               return scalar<contact_number>("contact_number", s, seen, exact);
             }},
    Quantity{"sticking_speed", "the exact value", no, no, no, nullptr, sticking_speed},
    Quantity{"stable_step", "the exact value", no, no, no, nullptr, stable_step},
    Quantity{"momentum", "all momentum that the run had or was given", no, ledger, no, momentum_error},
    Quantity{"energy", "the largest entry of the ledger", no, ledger, no, energy_error},
    Quantity{"particles", "the number of particles", no, no, no, lost_particles},
};

}  // namespace

std::span<const Quantity> quantities() {
  return table;
}

const Quantity* quantity_named(std::string_view name) {
  for (const Quantity& quantity : table)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

Measured relative_error(const Measured& seen, const Measured& exact, double zero_scale) {
  if (!seen.exists()) return seen;
  if (!exact.exists()) return Measured::none("the exact solution: " + exact.because);
  const double scale = exact.value == 0.0 ? zero_scale : std::abs(exact.value);
  if (scale == 0.0) return Measured::none("the exact value is zero, so a relative error has no meaning");
  return Measured::of((seen.value - exact.value) / scale);
}

}  // namespace grainproof
