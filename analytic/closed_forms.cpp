// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/closed_forms.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>

#include "analytic/periodic.hpp"
#include "model/errors.hpp"

namespace grainproof::analytic {
namespace {

struct Row {
  std::string_view name;
  Solution (*solve)(const Scene& scene, double until);
  bool of_periods = false;  ///< solves periodic domains by itself
};

constexpr std::array<Row, 18> table{{
    {"drag", drag},
    {"free_fall", free_fall},
    {"normal_collision", normal_collision},
    {"bounce", bounce},
    {"settling", settling},
    {"sliding", sliding},
    {"oblique_collision", oblique_collision},
    {"cohesive_collision", cohesive_collision},
    {"hertz_collision", hertz_collision},
    {"rolling", rolling},
    {"gross_sliding", gross_sliding},
    {"stick_slip", stick_slip},
    {"rolling_resistance", rolling_resistance},
    {"stacked", stacked},
    {"shaken", shaken},
    {"drum", drum},
    {"turntable", turntable},
    {"haff", haff, true},
}};

std::vector<double> times_of(const Scene& scene, const Request& request) {
  if (!request.every_step) return request.times.empty() ? scene.run.sample_times : request.times;
  std::vector<double> times;
  const std::int64_t last = step_at_or_after(scene.run.end, scene.run.step);
  for (std::int64_t n = 0; n <= last; ++n) times.push_back(static_cast<double>(n) * scene.run.step);
  return times;
}

Solution solved(const Row& row, const Scene& scene, const Request& request) {
  if (request.ledger) return Solution::no("a closed form keeps no ledger");
  const std::vector<double> times = times_of(scene, request);
  const double last = times.empty() ? 0.0 : *std::max_element(times.begin(), times.end());
  const double until = std::max(scene.run.end, last);
  return row.of_periods ? row.solve(scene, until) : solve_away_from_faces(row.solve, scene, until);
}

Observations observed(const Row& row, const Scene& scene, const Request& request) {
  const auto began = std::chrono::steady_clock::now();
  const Solution solution = solved(row, scene, request);
  if (!solution.support) throw EngineFailed(std::string(row.name) + ": " + solution.support.because);
  Observations seen;
  seen.provenance.engine = "closed_form";
  seen.provenance.variant = row.name;
  seen.scalars = solution.scalars;
  for (const double time : times_of(scene, request)) seen.frames.push_back(solution.frame_at(time));
  seen.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return seen;
}

class ClosedForm : public Engine {
 public:
  explicit ClosedForm(const Row& row) : row_(row) {}
  std::string name() const override { return "closed_form:" + std::string(row_.name); }
  Support supports(const Scene& scene, const Request& request) const override {
    return solved(row_, scene, request).support;
  }
  Observations observe(const Scene& scene, const Request& request) override {
    return observed(row_, scene, request);
  }

 private:
  const Row& row_;
};

class AnyClosedForm : public Engine {
 public:
  std::string name() const override { return "analytic"; }
  Support supports(const Scene& scene, const Request& request) const override {
    std::string because;
    for (const Row& row : table) {
      Support support = solved(row, scene, request).support;
      if (support) return support;
      because += (because.empty() ? "" : "; ") + std::string(row.name) + ": " + support.because;
    }
    return Support::no("no closed form applies: " + because);
  }
  Observations observe(const Scene& scene, const Request& request) override {
    for (const Row& row : table)
      if (solved(row, scene, request).support) return observed(row, scene, request);
    throw EngineFailed(supports(scene, request).because);
  }
};

}  // namespace

std::vector<std::string_view> closed_form_names() {
  std::vector<std::string_view> names;
  names.reserve(table.size());
  for (const Row& row : table) names.push_back(row.name);
  return names;
}

std::unique_ptr<Engine> make_closed_form(std::string_view name) {
  for (const Row& row : table)
    if (row.name == name) return std::make_unique<ClosedForm>(row);
  std::string known;
  for (const Row& row : table) known += (known.empty() ? "" : ", ") + std::string(row.name);
  throw InputRefused("found closed form \"" + std::string(name) + "\"; expected one of " + known);
}

std::unique_ptr<Engine> make_analytic_engine() {
  return std::make_unique<AnyClosedForm>();
}

}  // namespace grainproof::analytic
