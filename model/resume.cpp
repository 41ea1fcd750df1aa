// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "model/checkpoint.hpp"
#include "model/errors.hpp"
#include "model/ledger_numbers.hpp"

namespace grainproof {
namespace {

constexpr const char* ledger_before = "carried.before";
constexpr const char* ledger_at_start = "carried.at_start";

/// A run whose ledger goes on from that of the run before; all else is the run's own.
class CarriedOn : public RestartableRun {
 public:
  /// `before` and `at_start`: the ledger of the run before and the run's own, when it went on.
  CarriedOn(std::unique_ptr<RestartableRun> run, std::vector<double> before, std::vector<double> at_start)
      : run_(std::move(run)), before_(std::move(before)), at_start_(std::move(at_start)) {}

  void advance(std::int64_t steps) override { run_->advance(steps); }
  void synchronise() override { run_->synchronise(); }
  Frame frame() override { return run_->frame(); }
  void record(std::span<const std::int64_t> steps, std::vector<Frame>& frames) override {
    run_->record(steps, frames);
  }
  State state() override { return run_->state(); }
  std::uint64_t digest() override { return run_->digest(); }
  Counters counters() const override { return run_->counters(); }
  Ledger ledger() override;
  Checkpoint checkpoint() override;

 private:
  std::unique_ptr<RestartableRun> run_;
  std::vector<double> before_, at_start_;
};

Ledger CarriedOn::ledger() {
  std::vector<double> now = numbers_of(run_->ledger());
  if (now.size() != before_.size()) throw InputRefused("the checkpoint's ledger is of other walls");
  for (std::size_t i = ledger_energies_held; i < now.size(); ++i) now[i] += before_[i] - at_start_[i];
  return ledger_of(now);
}

Checkpoint CarriedOn::checkpoint() {
  Checkpoint made = run_->checkpoint();
  made.ledger = ledger();
  pack(made.own, ledger_before, before_);
  pack(made.own, ledger_at_start, at_start_);
  return made;
}

void require_same_particles(const Scene& scene, const State& state) {
  const std::size_t count = scene.particles.size();
  bool same = state.ids.size() == count && state.position.size() == count && state.velocity.size() == count;
  for (std::size_t i = 0; same && i < count; ++i) same = scene.particles[i].id == state.ids[i];
  if (!same) throw InputRefused("the checkpoint is not of the particles of this scene");
  if (state.angular_velocity.size() != (scene.rotation ? count : 0) ||
      state.orientation.size() != (scene.orientation != OrientationUpdate::none ? count : 0))
    throw InputRefused("the checkpoint does not tell of turning what this scene needs");
}

/// The scene with particles and contacts as they stand in `state`.
Scene standing_at(Scene scene, const State& state) {
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    Particle& particle = scene.particles[i];
    particle.position = state.position[i];
    particle.velocity = state.velocity[i];
    if (scene.rotation) particle.angular_velocity = state.angular_velocity[i];
  }
  scene.remembered = state.contacts;
  return scene;
}

}  // namespace

Checkpoint RestartableRun::portable() {
  Checkpoint made{.state = state()};
  if (made.state.velocity_lag == 0.0) return made;
  Frame now = frame();
  made.state.velocity = std::move(now.velocity);
  made.state.angular_velocity = std::move(now.angular_velocity);
  made.state.velocity_lag = 0.0;
  return made;
}

Resumed RestartableEngine::resume(const Scene& scene, const Request& request, const Checkpoint& from) {
  if (const Support support = supports(scene, request); !support)
    throw InputRefused(name() + " does not support this scene: " + support.because);
  require_same_particles(scene, from.state);
  Resumed resumed;
  try {
    resumed.run = restored(scene, request, from, resumed.not_exact_because);
  } catch (const InputRefused& refused) {
    resumed.not_exact_because = refused.what();
  }
  const bool exact = resumed.run != nullptr;
  if (!exact)
    resumed.run = go_on(standing_at(scene, from.state), request, {from.state.step, from.state.orientation});
  if (!request.ledger) return resumed;
  std::vector<double> before, at_start;
  if (!exact && from.ledger) {
    before = numbers_of(*from.ledger);
    at_start = numbers_of(resumed.run->ledger());
  } else if (exact && from.own.contains(sized<double>(ledger_before))) {
    unpack(from.own, ledger_before, before);
    unpack(from.own, ledger_at_start, at_start);
  }
  if (!before.empty())
    resumed.run = std::make_unique<CarriedOn>(std::move(resumed.run), std::move(before), std::move(at_start));
  return resumed;
}

}  // namespace grainproof
