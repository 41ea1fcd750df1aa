// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <functional>
#include <string>

#include "model/engine.hpp"
#include "tests/comparisons/scenes.hpp"

namespace grainproof::test {

/// An engine with a known fault: it rebounds from a fixed sphere with a relative error of
/// factor · (step/0.01 s)^order.
class Rebounder : public Engine {
 public:
  Rebounder(double factor, double order, double roundoff = 0x1p-53)
      : factor_(factor), order_(order), roundoff_(roundoff) {}

  std::string name() const override { return called; }
  Support supports(const Scene&, const Request& request) const override {
    return request.ledger ? Support::no("keeps no ledger") : Support{};
  }
  Observations observe(const Scene& scene, const Request&) override {
    ++observed;
    Observations seen;
    seen.provenance.precision = "double";
    seen.provenance.unit_roundoff = roundoff_;
    const double speed = 2.0 * restitution_value * (1.0 + factor_ * std::pow(scene.run.step / 0.01, order_));
    const Vec3 start = scene.particles[1].position;
    seen.frames.push_back({0, 0.0, {Vec3::Zero(), start}, {Vec3::Zero(), Vec3(-2.0, 0.0, 0.0)}});
    seen.frames.push_back({step_at_or_after(scene.run.end, scene.run.step),
                           scene.run.end,
                           {Vec3::Zero(), Vec3(0.2, 0.0, 0.0)},
                           {Vec3::Zero(), Vec3(speed, 0.0, 0.0)}});
    if (spoil) spoil(scene, seen);
    return seen;
  }

  std::string called = "rebounder";
  std::function<void(const Scene&, Observations&)> spoil;  ///< last change to what is seen
  int observed = 0;

 private:
  double factor_, order_, roundoff_;
};

}  // namespace grainproof::test
