// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <vector>

#include "input/set_up.hpp"
#include "input/uniform.hpp"

/// Places for many particles at once: the `fill` of a [[particles]] table.
namespace grainproof::input {

/// What a fill gives for one particle; what it doesn't give comes from the table around it.
struct Filled {
  Vec3 position;
  std::optional<Vec3> velocity;
  std::optional<std::int64_t> id;
  Vec3 angular_velocity = Vec3::Zero();
  std::optional<double> diameter = {};
};

/// The diameters of the particles of one table: all the same, or evenly distributed.
class Diameters {
 public:
  explicit Diameters(const Node& node);

  double least() const { return least_; }
  double most() const { return most_; }
  double next();

 private:
  double least_;
  double most_;
  std::optional<Uniform> draws_;
};

/// `largest`: the most particles that may be made. `scene` holds what stands there already.
std::vector<Filled> fill_lattice(const Table& table, Diameters& diameters, std::size_t largest);
std::vector<Filled> fill_random(const Table& table, Diameters& diameters, const Scene& scene,
                                std::size_t largest);
std::vector<Filled> fill_from_file(const Table& table, const std::filesystem::path& folder,
                                   std::size_t largest);

/// Whole numbers that a double, and so JSON, holds exactly.
constexpr std::int64_t largest_id = std::int64_t{1} << 53;

}  // namespace grainproof::input
