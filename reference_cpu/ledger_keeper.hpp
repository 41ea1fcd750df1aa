// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "model/observations.hpp"
#include "model/sections.hpp"
#include "reference_cpu/compensated_sum.hpp"
#include "reference_cpu/force_log.hpp"
#include "reference_cpu/onset/events.hpp"
#include "reference_cpu/walls.hpp"

namespace grainproof::reference {

/// Keeps energy and impulse from the very kicks that the integrator applies: a force F acting for a
/// time s does the work F·(v_before + v_after)/2 · s, which is what it adds to ½ m v². So the balance
/// drifts only by how well the kicks follow the potentials, which is the integrator's own error.
class LedgerKeeper {
 public:
  explicit LedgerKeeper(const Scene& scene) : log_(scene), sums_(scene.walls.size()) {}

  /// To be filled by whoever evaluates the forces.
  ForceLog& log() { return log_; }

  /// After the forces of the start: springs that it stretches are there, nobody has done work on them.
  void begin();
  void before_kick(const Bodies& bodies);
  void after_kick(const Bodies& bodies, double duration);

  /// Half of what a contact that began or ended has done, with the velocities as they are: once before they
  /// are corrected and once after.
  void half_of(const OnsetEvent& event, const Bodies& bodies, const Walls& walls, const PeriodicBox& box);

  /// The ledger at the current step. `pending` is how long (s) the present forces still have to act
  /// to bring the velocities up to the step boundary.
  Ledger at(const Bodies& bodies, double pending) const;

  void pack_into(Sections& own) const;
  void unpack_from(const Sections& own);

 private:
  /// Velocities before and after the forces in the log have acted for `duration`.
  struct Kick {
    const Bodies& bodies;
    const Motion& before;
    const Motion& after;
    double duration;

    Vec3 path(std::int32_t particle) const {
      return 0.5 * duration * (before.velocity[particle] + after.velocity[particle]);
    }
    Vec3 turn(std::int32_t particle) const {
      return 0.5 * duration * (before.angular_velocity[particle] + after.angular_velocity[particle]);
    }
  };

  struct WallSums {
    CompensatedSum<Vec3> impulse{Vec3::Zero()}, angular_impulse{Vec3::Zero()};
  };

  /// Since the start, but for the walls.
  struct Totals {
    CompensatedSum<double> gravity_work{0.0}, drag_work{0.0}, wall_work{0.0}, dissipated_normal{0.0},
        taken_by_friction{0.0}, taken_by_rolling{0.0};
    CompensatedSum<Vec3> support{Vec3::Zero()}, field{Vec3::Zero()};
  };

  /// Since the start.
  struct Sums : Totals {
    explicit Sums(std::size_t wall_count) : walls(wall_count) {}

    std::vector<WallSums> walls;
  };

  void book(Sums& sums, const Kick& kick) const;
  void book_contacts(Sums& sums, const Kick& kick) const;
  void book_rolling(Sums& sums, const Kick& kick) const;
  /// Path by which turning alone carries the surfaces past each other, before the cross product with n.
  static Vec3 sweep(const Kick& kick, const LoggedContact& contact);
  void book_on_wall(const OnsetEvent& event, const Bodies& bodies, const Walls& walls,
                    const PeriodicBox& box);
  void book_fields(Sums& sums, const Kick& kick) const;
  Vec3 drag_impulse(const Kick& kick, std::int32_t particle) const;

  ForceLog log_;
  Sums sums_;
  Motion before_;
};

}  // namespace grainproof::reference
