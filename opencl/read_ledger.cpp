// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/read_ledger.hpp"

#include "opencl/corrections.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

/// Rows of Tally, and of LedgerSums: sums, what rounding left out of them, and the start.
enum TallyRow { support, weight, drag, other, braking, rubbing, twisting, resisting, tally_rows };
constexpr std::size_t sum_rows = 3, ledger_rows = 2 * sum_rows + 1;
constexpr std::size_t wall_rows = 2;

class LedgerReader {
 public:
  LedgerReader(const LedgerBytes& bytes, const Decoder& decoder, const Frame& now, double pending)
      : bytes_(bytes), decoder_(decoder), now_(now), pending_(pending) {}

  /// What is pending acts on a body half-way from the velocity that is held to the one at the boundary,
  /// before contacts that began or ended have corrected it: those are in the sums.
  void add(std::size_t i, Ledger& l) const {
    const Vec3 settled = now_.velocity[i] - correction(i, 0);
    const Vec3 path = pending_ / 2 * (decoder_.vector(bytes_.velocities, i) + settled);
    l.support_impulse += sum(i, 0) + pending_ * now(i, support);
    l.field_impulse += sum(i, 1) + pending_ * (now(i, weight) + now(i, drag));
    l.gravity_work += sum(i, 2)[0] + now(i, weight).dot(path);
    l.drag_work += sum(i, 2)[1] + now(i, drag).dot(path);
    l.wall_work += sum_fourth(i, 2) + pending_ * now_fourth(i, other);
    l.dissipated_normal -= sum_fourth(i, 0) + now(i, braking).dot(path) - pending_ * now_fourth(i, support);
    l.dissipated_tangential -=
        sum_fourth(i, 1) + now(i, rubbing).dot(path) - pending_ * now_fourth(i, weight);
    l.dissipated_rolling -= sum(i, 2)[2] - pending_ * now_fourth(i, braking);
    add_energies(i, l);
  }

  void add_turning(std::size_t i, Ledger& l) const {
    const Vec3 settled = now_.angular_velocity[i] - correction(i, 2);
    const Vec3 turn = pending_ / 2 * (decoder_.vector(bytes_.spins, i) + settled);
    l.dissipated_tangential -= now(i, twisting).dot(turn);
    l.dissipated_rolling -= now(i, resisting).dot(turn);
  }

  void add_wall(std::size_t slot, std::size_t wall, Ledger& l) const {
    l.wall_impulses[wall] += of_wall(slot, 0);
    l.wall_angular_impulses[wall] += of_wall(slot, 1);
  }

 private:
  /// What springs have taken up since the start is not lost.
  void add_energies(std::size_t i, Ledger& l) const {
    const Vec3 before = decoder_.vector(bytes_.sums, ledger_rows * i + 2 * sum_rows), after = now(i, other);
    l.elastic += now_fourth(i, drag) + after[1] + after[2];
    l.cohesive += after[0];
    l.dissipated_tangential -= after[1] - before[1];
    l.dissipated_rolling -= after[2] - before[2];
  }
  Vec3 correction(std::size_t i, std::size_t word) const {
    if (bytes_.corrections.empty()) return Vec3::Zero();
    return decoder_.vector(bytes_.corrections, correction_words * i + word);
  }
  Vec3 sum(std::size_t i, std::size_t row) const {
    return decoder_.vector(bytes_.sums, ledger_rows * i + row) +
           decoder_.vector(bytes_.sums, ledger_rows * i + sum_rows + row);
  }
  double sum_fourth(std::size_t i, std::size_t row) const {
    return decoder_.fourth(bytes_.sums, ledger_rows * i + row) +
           decoder_.fourth(bytes_.sums, ledger_rows * i + sum_rows + row);
  }
  Vec3 of_wall(std::size_t slot, std::size_t row) const {
    return decoder_.vector(bytes_.wall_sums, 2 * wall_rows * slot + row) +
           decoder_.vector(bytes_.wall_sums, 2 * wall_rows * slot + wall_rows + row) +
           pending_ * decoder_.vector(bytes_.wall_tallies, wall_rows * slot + row);
  }
  Vec3 now(std::size_t i, TallyRow row) const {
    return decoder_.vector(bytes_.tallies, tally_rows * i + row);
  }
  double now_fourth(std::size_t i, TallyRow row) const {
    return decoder_.fourth(bytes_.tallies, tally_rows * i + row);
  }

  const LedgerBytes& bytes_;
  const Decoder& decoder_;
  const Frame& now_;
  double pending_;
};

}  // namespace

Ledger read_ledger(const Scene& scene, const NearWalls& walls, const Frame& now, const LedgerBytes& bytes,
                   const Decoder& decoder, double pending) {
  const LedgerReader reader(bytes, decoder, now, pending);
  Ledger ledger;
  ledger.wall_impulses.assign(scene.walls.size(), Vec3::Zero());
  ledger.wall_angular_impulses = ledger.wall_impulses;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    reader.add(i, ledger);
    ledger.kinetic += mass_of(scene.particles[i], scene) * now.velocity[i].squaredNorm() / 2;
    std::size_t slot = i * walls.count();
    walls.each(
        [&](const auto& wall) { reader.add_wall(slot++, static_cast<std::size_t>(wall.index), ledger); });
    if (!scene.rotation) continue;
    reader.add_turning(i, ledger);
    ledger.kinetic += inertia_of(scene.particles[i], scene) * now.angular_velocity[i].squaredNorm() / 2;
  }
  return ledger;
}

}  // namespace grainproof::opencl
