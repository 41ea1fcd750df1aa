// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "input/steps.hpp"
#include "input/sweep.hpp"
#include "input/text.hpp"
#include "input/transforms.hpp"

namespace grainproof::input {
namespace {

/// Expands the points that share the numbers of one scene.
class Expansion {
 public:
  Expansion(const Sweep& sweep, const Reading& reading, const std::vector<Rotation>& rotations,
            const SetUp& set_up, std::map<std::string, std::string> values, int first_sample,
            std::vector<ResolvedScene>& out)
      : sweep_(sweep),
        reading_(reading),
        rotations_(rotations),
        set_up_(set_up),
        values_(std::move(values)),
        first_sample_(first_sample),
        contact_(shortest_contact_of(set_up)),
        out_(out) {
    if (sweep_.onset) check_touching(set_up_.scene, *sweep_.onset);
  }

  void over_integrators() {
    if (sweep_.integrators.empty()) return over_scales();
    for (const IntegratorSweep& swept : sweep_.integrators) {
      set_up_.scene.run.integrator = swept.integrator;
      values_["integrator"] = name_of(swept.integrator);
      over_scales();
    }
  }

 private:
  void over_scales() {
    if (sweep_.scales.empty()) return over_offsets();
    const SetUp as_written = set_up_;
    for (const Node& scale : sweep_.scales) {
      scale_ = scale.number();
      set_up_ = as_written;
      if (!rescale(set_up_, scale_))
        scale.refuse("a scale at which each mass, length, time and stiffness can be written as a number");
      contact_ = shortest_contact_of(set_up_);
      values_["scale"] = scale.label();
      over_offsets();
    }
    set_up_ = as_written;
  }

  void over_offsets() {
    const StabilityGuard guard(set_up_, reading_.options.force);
    if (sweep_.offsets.empty()) return over_steps(set_up_.scene, guard);
    for (const Node& offset : sweep_.offsets) {
      Scene moved = set_up_.scene;
      shift(moved, offset_of(offset, moved), offset);
      check_still_inside(moved, offset);
      check_still_apart(moved, offset);
      values_["offset"] = offset.label();
      over_steps(moved, guard);
    }
  }

  void over_steps(const Scene& scene, const StabilityGuard& guard) {
    const auto over = [&](const StepWish& wish) {
      over_rotations(scene, with_error_resolved(wish, scene, set_up_.impact_speed), guard);
    };
    if (sweep_.steps.empty()) return over(*set_up_.step);
    for (StepWish wish : sweep_.steps) {
      wish.seconds *= scale_;
      over(wish);
    }
  }

  void over_rotations(const Scene& scene, const StepWish& wish, const StabilityGuard& guard) {
    int sample = first_sample_;
    for (const Rotation& rotation : rotations_) {
      Scene turned = scene;
      if (sweep_.orientations) {
        rotate(turned, rotation, sweep_.orientations->place);
        check_still_inside(turned, sweep_.orientations->place);
        check_still_apart(turned, sweep_.orientations->place);
      }
      for (int phase = 0; phase < sweep_.phases(); ++phase) add(turned, wish, phase, sample++, guard);
    }
  }

  void add(const Scene& scene, const StepWish& wish, int phase, int sample, const StabilityGuard& guard) {
    const int dithered = sweep_.onset ? phase : sample;
    const double step = resolved_step(wish, sweep_.step_dither ? dither(dithered) : 0.0, contact_);
    guard.check(step, wish.place);
    check_strides(scene, step, wish.place);
    ResolvedScene& resolved =
        out_.emplace_back(ResolvedScene{scene, {wish.label, wish.steps_per_contact, sample, values_}});
    resolved.point.step_because = wish.because;
    RunSettings& run = resolved.scene.run;
    run.step = step;
    run.sample_times = sample_times(set_up_.record, run.end, step, wish.place);
    if (!sweep_.onset) return;
    start_earlier(resolved.scene, (phase + 0.5) / sweep_.onset->phases * step);
    check_still_inside(resolved.scene, sweep_.onset->place);
    check_still_apart(resolved.scene, sweep_.onset->place);
  }

  const Sweep& sweep_;
  const Reading& reading_;
  const std::vector<Rotation>& rotations_;
  SetUp set_up_;
  std::map<std::string, std::string> values_;
  int first_sample_;
  std::optional<double> contact_;
  double scale_ = 1.0;
  std::vector<ResolvedScene>& out_;
};

void check_size(const Table& file, const Sweep& sweep, const ReadOptions& options) {
  if (sweep.size() <= static_cast<double>(options.most_scenes)) return;
  file.at("sweep").refuse("a sweep over " + shortest(sweep.size()) + " scenes",
                          "at most " + std::to_string(options.most_scenes));
}

void check_particles(const Table& file, const Sweep& sweep, const SetUp& set_up, const ReadOptions& options) {
  const double all = sweep.size() * static_cast<double>(set_up.scene.particles.size());
  if (all <= static_cast<double>(options.most_particles)) return;
  file.at("sweep").refuse("a sweep over " + shortest(all) + " particles in all",
                          "at most " + std::to_string(options.most_particles));
}

/// The next combination of one index a number; false after the last.
bool advance(std::vector<std::size_t>& at, const std::vector<NumberSweep>& numbers) {
  for (std::size_t i = numbers.size(); i-- > 0;) {
    if (++at[i] < numbers[i].values.size()) return true;
    at[i] = 0;
  }
  return false;
}

}  // namespace

std::vector<ResolvedScene> expand(Document& document, const Sweep& sweep, const Reading& reading) {
  const Table file = root(document);
  check_size(file, sweep, reading.options);
  const auto rotations = rotations_of(sweep);
  std::vector<ResolvedScene> out;
  std::vector<std::size_t> at(sweep.numbers.size());
  do {
    std::map<std::string, std::string> values;
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Node& value = sweep.numbers[i].values[at[i]];
      document.replaced[sweep.numbers[i].target] = &value.raw();
      values[sweep.numbers[i].path] = value.label();
    }
    for (int seeding = 0; seeding < sweep.seedings(); ++seeding) {
      document.seed_shift = seeding;
      const SetUp set_up = read_set_up(document, reading);
      if (!set_up.step && sweep.steps.empty()) (void)file.at("run").table().at("step");
      check_particles(file, sweep, set_up, reading.options);
      if (out.empty()) out.reserve(static_cast<std::size_t>(sweep.size()));
      Expansion(sweep, reading, rotations, set_up, values, seeding * sweep.rotations() * sweep.phases(), out)
          .over_integrators();
    }
  } while (advance(at, sweep.numbers));
  document.replaced.clear();
  document.seed_shift = 0;
  return out;
}

}  // namespace grainproof::input
