// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/scene.hpp"
#include "reference_cpu/laws/friction.hpp"
#include "reference_cpu/laws/hertz_normal.hpp"
#include "reference_cpu/laws/linear_cohesion.hpp"
#include "reference_cpu/laws/linear_normal.hpp"
#include "reference_cpu/laws/rolling.hpp"
#include "reference_cpu/laws/tangential_spring.hpp"

namespace grainproof::reference {

/// The laws of one pair of materials as plain numbers, resolved once so that no pair is dispatched.
/// Where there is a Hertz contact it replaces `normal`, where there is a tangential spring `friction`.
struct PairLaws {
  SpringDashpot normal;
  SlipFriction friction;
  EffectSpring cohesion;
  HertzContact hertz;
  TangentialSpring spring;
  RollingResistance rolling;
  double arm_shortening = 0.0;  ///< torque arm: radius less this share of the overlap
  /// Linear springs, along the normal and against slip, that nothing is made of but ζ laid into the plane.
  bool only_springs = false;

  bool remembers() const { return spring.present() || rolling.spring; }

  /// Linear springs and friction without memory: what the fast loops know.
  bool simple() const { return !hertz.present() && !spring.present() && !rolling.present(); }
};

/// Of the materials a and b of the scene, which has laws for them.
PairLaws resolve(const Scene& scene, std::size_t a, std::size_t b);

class LawTable {
 public:
  explicit LawTable(const Scene& scene);

  /// Unset pairs never meet: supports() has made sure.
  const PairLaws& at(std::int32_t a, std::int32_t b) const { return laws_[a * materials_ + b]; }

  bool all_simple() const;

 private:
  std::size_t materials_;
  std::vector<PairLaws> laws_;
};

}  // namespace grainproof::reference
