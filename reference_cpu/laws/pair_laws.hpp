// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/materials.hpp"
#include "reference_cpu/laws/friction.hpp"
#include "reference_cpu/laws/linear_cohesion.hpp"
#include "reference_cpu/laws/linear_normal.hpp"

namespace grainproof::reference {

/// The laws of one pair of materials as plain numbers, resolved once so that no pair is dispatched.
struct PairLaws {
  SpringDashpot normal;
  SlipFriction friction;
  EffectSpring cohesion;
};

PairLaws resolve(const ContactLaws& laws, double step);

class LawTable {
 public:
  LawTable(const ContactTable& contacts, double step);

  /// Unset pairs never meet: supports() has made sure.
  const PairLaws& at(std::int32_t a, std::int32_t b) const { return laws_[a * materials_ + b]; }

 private:
  std::size_t materials_;
  std::vector<PairLaws> laws_;
};

}  // namespace grainproof::reference
