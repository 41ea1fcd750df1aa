// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>

#include "model/engine.hpp"

namespace grainproof::analytic {

/// What a closed form says of one scene.
struct Solution {
  Support support;
  std::function<Frame(double time)> frame_at;
  std::map<std::string, double> scalars;

  static Solution no(std::string because) { return {Support::no(std::move(because)), {}, {}}; }
};

/// At a time in s; bodies are still to be added.
inline Frame empty_frame(const Scene& scene, double time) {
  Frame frame;
  frame.step = step_at_or_after(time, scene.run.step);
  frame.time = time;
  return frame;
}

/// Each solves a scene for the times from 0 to `until`, or says why it does not apply.
Solution bounce(const Scene& scene, double until);
Solution cohesive_collision(const Scene& scene, double until);
Solution drag(const Scene& scene, double until);
Solution drum(const Scene& scene, double until);
Solution free_fall(const Scene& scene, double until);
Solution gross_sliding(const Scene& scene, double until);
Solution haff(const Scene& scene, double until);
Solution hertz_collision(const Scene& scene, double until);
Solution normal_collision(const Scene& scene, double until);
Solution oblique_collision(const Scene& scene, double until);
Solution rolling(const Scene& scene, double until);
Solution rolling_resistance(const Scene& scene, double until);
Solution settling(const Scene& scene, double until);
Solution shaken(const Scene& scene, double until);
Solution sliding(const Scene& scene, double until);
Solution stacked(const Scene& scene, double until);
Solution stick_slip(const Scene& scene, double until);
Solution turntable(const Scene& scene, double until);

}  // namespace grainproof::analytic
