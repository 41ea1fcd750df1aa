// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/read_ledger.hpp"

#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

/// Rows of Tally, four vectors a particle, and of LedgerSums, three sums and three rests.
enum TallyRow { support, weight, drag, other, tally_rows };
constexpr std::size_t sum_rows = 3;

class LedgerReader {
 public:
  LedgerReader(const LedgerBytes& bytes, const Decoder& decoder, double pending)
      : bytes_(bytes), decoder_(decoder), pending_(pending) {}

  void add(std::size_t i, Ledger& l) const {
    const Vec3 held = decoder_.vector(bytes_.velocities, i);
    l.support_impulse += sum(i, 0) + pending_ * now(i, support);
    l.dissipated_normal += sum_fourth(i, 0) + pending_ * now_fourth(i, support);
    l.field_impulse += sum(i, 1) + pending_ * (now(i, weight) + now(i, drag));
    l.dissipated_tangential += sum_fourth(i, 1) + pending_ * now_fourth(i, weight);
    l.gravity_work += sum(i, 2)[0] + pending_ * now(i, weight).dot(held);
    l.drag_work += sum(i, 2)[1] + pending_ * now(i, drag).dot(held);
    l.elastic += now_fourth(i, drag);
    l.cohesive += now(i, other)[0];
  }

 private:
  Vec3 sum(std::size_t i, std::size_t row) const {
    return decoder_.vector(bytes_.sums, 2 * sum_rows * i + row) +
           decoder_.vector(bytes_.sums, 2 * sum_rows * i + sum_rows + row);
  }
  double sum_fourth(std::size_t i, std::size_t row) const {
    return decoder_.fourth(bytes_.sums, 2 * sum_rows * i + row) +
           decoder_.fourth(bytes_.sums, 2 * sum_rows * i + sum_rows + row);
  }
  Vec3 now(std::size_t i, TallyRow row) const {
    return decoder_.vector(bytes_.tallies, tally_rows * i + row);
  }
  double now_fourth(std::size_t i, TallyRow row) const {
    return decoder_.fourth(bytes_.tallies, tally_rows * i + row);
  }

  const LedgerBytes& bytes_;
  const Decoder& decoder_;
  double pending_;
};

}  // namespace

Ledger read_ledger(const Scene& scene, const Frame& now, const LedgerBytes& bytes, const Decoder& decoder,
                   double pending) {
  const LedgerReader reader(bytes, decoder, pending);
  Ledger ledger;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    reader.add(i, ledger);
    ledger.kinetic += mass_of(scene.particles[i], scene) * now.velocity[i].squaredNorm() / 2;
    if (scene.rotation)
      ledger.kinetic += inertia_of(scene.particles[i], scene) * now.angular_velocity[i].squaredNorm() / 2;
  }
  return ledger;
}

}  // namespace grainproof::opencl
