// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/fills.hpp"

namespace grainproof::input {

Diameters::Diameters(const Node& node) {
  if (!node.is_table()) {
    least_ = most_ = node.positive();
    return;
  }
  const Table table = node.table();
  table.only({"uniform", "seed"});
  const Node bounds = table.at("uniform");
  const auto ends = bounds.elements();
  if (ends.size() != 2) bounds.refuse("two diameters, the least and the largest");
  least_ = ends[0].positive();
  most_ = ends[1].positive();
  if (least_ > most_) bounds.refuse("uniform = " + bounds.label(), "the least diameter first");
  draws_ = Uniform(table.at("seed").seed());
}

double Diameters::next() {
  return draws_ ? least_ + (*draws_)() * (most_ - least_) : most_;
}

}  // namespace grainproof::input
