// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/vec3.hpp"

namespace grainproof {

/// All particles at one step boundary, in the order of Scene::particles.
struct Frame {
  std::int64_t step = 0;
  double time = 0.0;                         ///< s, the frame's own, not the one asked for
  std::vector<Vec3> position;                ///< m; inside the domain along periodic axes
  std::vector<Vec3> velocity;                ///< m/s, synchronised with `time`
  std::vector<Vec3> angular_velocity = {};   ///< rad/s, likewise; empty without rotation
  std::vector<Quaternion> orientation = {};  ///< empty unless Scene::orientation asks for it
};

/// Energy in J and impulse in N s since the start of the run, over all moving particles.
/// balance() is constant up to the integrator's error.
struct Ledger {
  double kinetic = 0.0;                 ///< of translation and of rotation
  double elastic = 0.0;                 ///< in normal and in tangential springs
  double cohesive = 0.0;                ///< potential, never positive
  double gravity_work = 0.0;            ///< done on the particles
  double drag_work = 0.0;               ///< done on the particles by the fluid
  double wall_work = 0.0;               ///< done on the particles by moving walls
  double dissipated_normal = 0.0;       ///< taken out by normal dashpots
  double dissipated_tangential = 0.0;   ///< taken out by friction
  double dissipated_rolling = 0.0;      ///< taken out by rolling resistance; its spring counts as elastic
  Vec3 support_impulse = Vec3::Zero();  ///< from walls and fixed particles
  Vec3 field_impulse = Vec3::Zero();    ///< from gravity and drag
  std::vector<Vec3> wall_impulses;      ///< from each wall on the particles, in the order of Scene::walls
  /// N m s, of the same forces about each wall's reference point (model/walls.hpp) at the time they acted.
  std::vector<Vec3> wall_angular_impulses;

  double balance() const {
    return kinetic + elastic + cohesive - gravity_work - drag_work - wall_work + dissipated_normal +
           dissipated_tangential + dissipated_rolling;
  }
};

/// How a run ended. Failure is a value: a run that went wrong still has its frames up to there.
struct Outcome {
  enum class Status { completed, went_wrong } status = Status::completed;
  std::string reason;  ///< cause and what to do about it; empty when completed
  std::int64_t step = 0;
  double time = 0.0;                    ///< s
  std::vector<std::int64_t> particles;  ///< ids involved
};

/// Work done, for summaries and benchmarks.
struct Counters {
  std::int64_t steps = 0;
  std::int64_t list_rebuilds = 0;
  std::int64_t listed_pairs = 0;
  double step_loop_wall_s = 0.0;
  double skin = 0.0;              ///< m, of the last list; 0 where it isn't told
  std::int64_t device_bytes = 0;  ///< in buffers of a device, all added up; 0 where they aren't counted
};

/// Where a result came from.
struct Provenance {
  std::string engine;     ///< "reference", "opencl", "closed_form", "liggghts", …
  std::string precision;  ///< "single", "mixed", "double"; empty for a closed form
  std::string device;
  std::string version;
  std::string variant;         ///< which of a peer's laws was used, where there was a choice
  double unit_roundoff = 0.0;  ///< of the precision: 2^-24 or 2^-53; 0 for a closed form
};

struct Observations {
  std::vector<Frame> frames;
  std::map<std::string, double> scalars;  ///< named results, SI; e.g. a closed form's "restitution"
  std::optional<Ledger> initial_ledger;
  std::optional<Ledger> final_ledger;
  Counters counters;
  Outcome outcome;
  Provenance provenance;
  double wall_s = 0.0;
};

}  // namespace grainproof
