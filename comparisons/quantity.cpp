// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/quantity.hpp"

#include <array>
#include <cmath>
#include <string>

#include "comparisons/metrics/bed.hpp"
#include "comparisons/metrics/bulk.hpp"
#include "comparisons/metrics/collision.hpp"
#include "comparisons/metrics/curves.hpp"
#include "comparisons/metrics/invariants.hpp"
#include "comparisons/metrics/resting.hpp"
#include "comparisons/metrics/turning.hpp"

namespace grainproof {
namespace {

constexpr std::string_view exact_value_itself = "the exact value";

constexpr Quantity number(std::string_view name, Quantity::Value value) {
  return {.name = name, .relative_to = exact_value_itself, .value = value};
}

constexpr Quantity number_of_every_step(std::string_view name, Quantity::Value value) {
  return {.name = name, .relative_to = exact_value_itself, .value = value, .every_step = true};
}

constexpr Quantity number_of_ledger(std::string_view name, Quantity::Value value) {
  return {.name = name, .relative_to = exact_value_itself, .value = value, .ledger = true};
}

constexpr Quantity curve(std::string_view name, std::string_view relative_to, Quantity::Compare compare) {
  return {.name = name, .relative_to = relative_to, .compare = compare, .curve = true};
}

constexpr Quantity invariant(std::string_view name, std::string_view relative_to, Quantity::Compare compare,
                             bool ledger) {
  return {.name = name, .relative_to = relative_to, .compare = compare, .ledger = ledger};
}

constexpr Quantity searched(std::string_view name, Quantity::Search search) {
  return {.name = name, .relative_to = exact_value_itself, .search = search};
}

const std::array table{
    curve("position", "the longest path of a particle", position_error),
    curve("velocity", "the largest exact speed", velocity_error),
    curve("angular_velocity", "the largest exact spin, or speed over radius where nothing turns",
          angular_velocity_error),
    curve("orientation", "one radian", orientation_error),
    curve("kinetic_energy", "its largest exact value", kinetic_energy_error),
    Quantity{.name = "restitution",
             .relative_to = "the exact value; the approach speed where that is zero",
             .value = restitution,
             .zero_scale = 1.0},
    number("tangential_velocity_change", tangential_velocity_change),
    number_of_every_step("contact_duration", contact_duration),
    number_of_every_step("peak_overlap", peak_overlap),
    number("resting_overlap", resting_overlap),
    number_of_every_step("stop_time", stop_time),
    number("stop_distance", stop_distance),
    number("spin", final_spin),
    number_of_ledger("wall_impulse:0", wall_impulse<0>),
    number_of_ledger("wall_impulse:1", wall_impulse<1>),
    number_of_ledger("wall_impulse:2", wall_impulse<2>),
    number_of_ledger("wall_impulse:3", wall_impulse<3>),
    number_of_ledger("wall_angular_impulse:0", wall_angular_impulse<0>),
    number_of_ledger("wall_angular_impulse:1", wall_angular_impulse<1>),
    number_of_ledger("wall_work", wall_work),
    number("bed_height", bed_height),
    number("contact_number", contact_number),
    number("mean_contact_number", mean_contact_number),
    number("mean_kinetic_energy", mean_kinetic_energy),
    number("packing_lower", packing_of_third<0>),
    number("packing_middle", packing_of_third<1>),
    number("packing_upper", packing_of_third<2>),
    number("contact_force", contact_force),
    number("contact_force_spread", contact_force_spread),
    number("discharge_rate", discharge_rate),
    number("slope_angle", slope_angle),
    searched("sticking_speed", sticking_speed),
    searched("stable_step", stable_step),
    invariant("momentum", "all momentum that the run had or was given", momentum_error, true),
    invariant("angular_momentum", "all angular momentum that the run had or was given",
              angular_momentum_error, true),
    invariant("energy", "the largest entry of the ledger", energy_error, true),
    invariant("particles", "the number of particles", lost_particles, false),
};

}  // namespace

Measured Quantity::exact_value(const Scene& scene, const Observations& exact) const {
  if (const auto told = exact.scalars.find(std::string(name)); told != exact.scalars.end())
    return Measured::of(told->second);
  if (exact.frames.empty())
    return Measured::none("the exact solution does not say \"" + std::string(name) + "\"");
  return value(scene, exact);
}

Measured Quantity::error(const Scene& scene, const Observations& seen, const Observations& exact) const {
  if (compare) return compare(scene, seen, exact);
  return relative_error(value(scene, seen), exact_value(scene, exact), zero_scale);
}

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
