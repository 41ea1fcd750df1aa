// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/space_order.hpp"

namespace grainproof::reference {
namespace {

/// Fewer fit into the caches in any order.
constexpr std::size_t many_particles = 4096;

/// In as many lists a particle has moved by about its own diameter.
constexpr std::int64_t lists_between = 32;

std::vector<std::int32_t> inverse_of(const std::vector<std::int32_t>& order) {
  std::vector<std::int32_t> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<std::int32_t>(i);
  return place;
}

}  // namespace

SpaceOrder::SpaceOrder(const Scene& scene)
    : sorts_(scene.run.order == SumOrder::fast && scene.particles.size() >= many_particles) {}

void SpaceOrder::before_list(Neighbours& neighbours, Bodies& bodies, ContactHistory& history,
                             Touching& touching) {
  if (!sorts_ || lists_++ % lists_between != 0) return;
  const std::vector<std::int32_t> order = neighbours.order_in_space(bodies);
  reorder(bodies, order);
  const std::vector<std::int32_t> place = inverse_of(order);
  history.renumber(place);
  touching.renumber(place);
}

}  // namespace grainproof::reference
