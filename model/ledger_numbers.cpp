// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "model/ledger_numbers.hpp"

#include "model/errors.hpp"

namespace grainproof {

std::vector<double> numbers_of(const Ledger& ledger) {
  std::vector<double> numbers;
  const auto add = [&](const Vec3& v) { numbers.insert(numbers.end(), v.data(), v.data() + 3); };
  for (const auto energy : ledger_energies) numbers.push_back(ledger.*energy);
  add(ledger.support_impulse);
  add(ledger.field_impulse);
  for (std::size_t wall = 0; wall < ledger.wall_impulses.size(); ++wall) {
    add(ledger.wall_impulses[wall]);
    add(ledger.wall_angular_impulses[wall]);
  }
  return numbers;
}

Ledger ledger_of(const std::vector<double>& numbers) {
  constexpr std::size_t fixed = ledger_energies.size() + 6;
  if (numbers.size() < fixed || (numbers.size() - fixed) % 6 != 0)
    throw InputRefused("a ledger of the checkpoint has " + std::to_string(numbers.size()) + " numbers");
  Ledger ledger;
  std::size_t at = 0;
  const auto next = [&] {
    at += 3;
    return Vec3(numbers[at - 3], numbers[at - 2], numbers[at - 1]);
  };
  for (const auto energy : ledger_energies) ledger.*energy = numbers[at++];
  ledger.support_impulse = next();
  ledger.field_impulse = next();
  while (at < numbers.size()) {
    ledger.wall_impulses.push_back(next());
    ledger.wall_angular_impulses.push_back(next());
  }
  return ledger;
}

}  // namespace grainproof
