// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>

#include "model/checkpoint.hpp"
#include "reference_cpu/contacts.hpp"
#include "reference_cpu/integrators/scheme.hpp"
#include "reference_cpu/ledger_keeper.hpp"
#include "reference_cpu/onset/boundary_step.hpp"
#include "reference_cpu/space_order.hpp"

namespace grainproof::reference {

/// Who can read a checkpoint's own part.
inline constexpr const char* checkpoint_maker = "reference";

/// A step moves the particles, looks who is near whom where that may have changed, and sums the
/// forces at the new place, so that between steps forces and state belong together.
class ReferenceRun : public RestartableRun {
 public:
  ReferenceRun(const Scene& scene, bool with_ledger, const Beginning& beginning = {});

  void advance(std::int64_t steps) override;
  void synchronise() override {}
  Frame frame() override;
  State state() override;
  std::uint64_t digest() override;
  Counters counters() const override;
  Ledger ledger() override;
  Checkpoint checkpoint() override;
  /// Takes over what checkpoint() has put into its own part. Throws InputRefused.
  void restore(const Sections& own);

 private:
  void take_step();
  void take_substeps();
  /// Bodies as they are for `duration` (s), up to the time `now`.
  void drift_on(double duration, double now);
  template <class Kick>
  void kick(Kick apply);
  bool leapt(const Body& body, double step) const;
  void confine(double step);
  void find_neighbours();
  /// Contacts that already were have lasted `elapsed` (s) longer than at the evaluation before.
  void evaluate_forces(double elapsed, double now);
  /// The first of two evaluations: what acts besides dashpots, and the velocities that foretells.
  void evaluate_springs(double elapsed, double now);
  void clear_forces();
  void add_contacts(double elapsed, ForceLog* log);
  /// What began or ended within the step.
  void correct_onsets();
  void book_half_of_onsets();
  void check_velocities();
  void raise_trouble() const;
  std::vector<Vec3> positions() const;
  double time() const { return static_cast<double>(step_) * scene_.run.step; }
  /// By how many steps the held velocities are behind; none before the first step.
  double velocity_lag() const { return step_ == first_step_ ? 0.0 : scheme_.velocity_lag; }

  const Vec3 origin_;  ///< of the coordinates that the run counts in
  const Scene scene_;  ///< in those
  const Scheme scheme_;
  const PeriodicBox box_;
  Walls walls_;
  const LawTable laws_;
  const bool cohesion_;
  const bool simple_;
  const bool may_leap_;
  Bodies bodies_;
  Neighbours neighbours_;
  SpaceOrder space_order_;
  ContactHistory history_;
  OnsetEvents events_;
  Touching touching_;
  Watch watch_;
  std::optional<LedgerKeeper> ledger_;
  std::int64_t first_step_;
  std::int64_t step_;
  double step_loop_wall_s_ = 0.0;
};

}  // namespace grainproof::reference
