// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/laws.hpp"

namespace grainproof {

/// Isotropic, linear; what Hertz contacts are made from.
struct Elasticity {
  double youngs_modulus;  ///< Pa
  double poisson_ratio;   ///< in (−1, 0.5]
};

struct Material {
  std::string name;
  double density;  ///< kg/m³
  std::optional<Elasticity> elasticity = std::nullopt;
};

/// The laws of every pair of materials, symmetric in the pair.
class ContactTable {
 public:
  explicit ContactTable(std::size_t materials = 0) : materials_(materials), laws_(materials * materials) {}

  void set(std::size_t a, std::size_t b, ContactLaws laws) {
    laws_[a * materials_ + b] = laws;
    laws_[b * materials_ + a] = std::move(laws);
  }

  bool has(std::size_t a, std::size_t b) const { return laws_[a * materials_ + b].has_value(); }

  /// Throws std::bad_optional_access for a pair that was never set; the reader refuses such scenes.
  const ContactLaws& at(std::size_t a, std::size_t b) const { return laws_[a * materials_ + b].value(); }

  std::size_t materials() const { return materials_; }

 private:
  std::size_t materials_;
  std::vector<std::optional<ContactLaws>> laws_;
};

}  // namespace grainproof
