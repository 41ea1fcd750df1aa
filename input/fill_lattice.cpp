// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/fills.hpp"

namespace grainproof::input {
namespace {

struct Lattice {
  std::array<std::int64_t, 3> counts;
  Vec3 origin;
  Vec3 spacing;
};

std::array<std::int64_t, 3> read_counts(const Node& node, std::size_t largest) {
  const auto elements = node.elements();
  if (elements.size() != 3) node.refuse("three whole numbers, one an axis");
  const auto most = static_cast<std::int64_t>(largest);
  std::array<std::int64_t, 3> counts{};
  double product = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    counts[axis] = elements[axis].integer_within(1, most);
    product *= static_cast<double>(counts[axis]);
  }
  if (product > static_cast<double>(largest))
    node.refuse("a lattice of " + node.label(), "at most " + std::to_string(largest) + " particles");
  return counts;
}

Vec3 read_spacing(const Node& node) {
  if (!node.is_array()) return Vec3::Constant(node.positive());
  const Vec3 spacing = node.vector();
  if (!(spacing.array() > 0.0).all()) node.refuse("numbers above 0");
  return spacing;
}

void jitter(std::vector<Filled>& filled, double amplitude, std::int64_t seed) {
  Uniform uniform(seed);
  for (Filled& particle : filled) particle.position += amplitude * uniform.in_cube();
}

}  // namespace

std::vector<Filled> fill_lattice(const Table& table, Diameters& diameters, std::size_t largest) {
  table.only({"kind", "counts", "origin", "spacing", "jitter", "seed"});
  const auto spacing = table.find("spacing");
  const Lattice lattice{read_counts(table.at("counts"), largest), table.at("origin").vector(),
                        spacing ? read_spacing(*spacing) : Vec3::Constant(diameters.most())};
  std::vector<Filled> filled;
  for (std::int64_t z = 0; z < lattice.counts[2]; ++z)
    for (std::int64_t y = 0; y < lattice.counts[1]; ++y)
      for (std::int64_t x = 0; x < lattice.counts[0]; ++x) {
        const Vec3 cell(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
        filled.push_back(
            {lattice.origin + cell.cwiseProduct(lattice.spacing), {}, {}, Vec3::Zero(), diameters.next()});
      }
  if (const auto amplitude = table.find("jitter"))
    jitter(filled, amplitude->not_negative(), table.at("seed").seed());
  return filled;
}

}  // namespace grainproof::input
