// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "analytic/step_for_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

#include "analytic/contact_scales.hpp"
#include "analytic/possible_contacts.hpp"

namespace grainproof::analytic {
namespace {

/// Errors that fall more slowly than this have met something that the step does not resolve.
constexpr double least_order = 0.5;

std::string brief(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

/// Which of the measured laws one is, or why it is none.
struct Kind {
  ErrorLaw law = ErrorLaw::linear;
  std::string lacks;
};

Kind kind_of(const ContactLaws& laws) {
  const auto no = [](const std::string& what) { return Kind{{}, "no errors were measured with " + what}; };
  if (!std::holds_alternative<NoCohesion>(laws.cohesion)) return no("cohesion");
  if (!std::holds_alternative<NoRolling>(laws.rolling)) return no("resistance to rolling");
  const bool history = std::holds_alternative<HistoryFriction>(laws.friction);
  if (!history && !std::holds_alternative<Frictionless>(laws.friction))
    return no("friction laws other than history");
  if (std::holds_alternative<HertzNormal>(laws.normal))
    return {history ? ErrorLaw::hertz_history : ErrorLaw::hertz, ""};
  if (!std::get<LinearNormal>(laws.normal).no_tension)
    return {history ? ErrorLaw::linear_history : ErrorLaw::linear, ""};
  if (history) return no("no_tension together with friction");
  return {ErrorLaw::no_tension, ""};
}

double restitution_of(const ContactLaws& laws, const ContactScale& scale) {
  return std::visit(Overloaded{[&](const LinearNormal& law) {
                                 if (const auto* given = std::get_if<Restitution>(&law.dissipation))
                                   return given->value;
                                 return law.no_tension
                                            ? no_tension_restitution_of(scale.damping, scale.stiffness,
                                                                        scale.effective_mass)
                                            : analytic::restitution_of(scale.damping, scale.stiffness,
                                                                       scale.effective_mass);
                               },
                               [](const HertzNormal& law) {
                                 const auto* given = std::get_if<Restitution>(&law.dissipation);
                                 return given ? given->value : std::numeric_limits<double>::quiet_NaN();
                               }},
                    laws.normal);
}

/// Without drag implicit drag is none.
Integrator measured_as(Integrator integrator, ErrorLaw law) {
  return integrator == Integrator::euler_trapezoid_implicit_drag && law != ErrorLaw::drag
             ? Integrator::euler_trapezoid
             : integrator;
}

/// The rows whose restitutions enclose this one: the errors between are taken to be no larger than both.
std::vector<const MeasuredErrors*> rows_about(ErrorLaw law, Integrator integrator, double restitution) {
  const MeasuredErrors *above = nullptr, *below = nullptr;
  for (const MeasuredErrors& row : measured_errors()) {
    if (row.law != law || row.integrator != measured_as(integrator, law)) continue;
    if (row.restitution >= restitution && (!above || row.restitution < above->restitution)) above = &row;
    if (row.restitution <= restitution && (!below || row.restitution > below->restitution)) below = &row;
  }
  if (!above || !below) return {};
  if (above == below) return {above};
  return {above, below};
}

void keep_smaller(StepForError& choice, double step, const std::string& because) {
  if (choice.step > 0.0 && step >= choice.step) return;
  choice.step = step;
  choice.because = because;
}

std::string explained(const std::string& what, double time, Integrator integrator,
                      const StepsForError& found) {
  const std::string steps = brief(found.steps) + " steps of " + what + " (" + brief(time) + " s) with " +
                            std::string(name_of(integrator));
  if (found.steps <= measured_at.front()) return steps + ", the fewest that errors were measured at";
  return steps + ", where error ≈ " + brief(found.constant) + " (Δt/t)^" + brief(found.order) + ", measured";
}

void keep_smallest_of(StepForError& choice, const std::vector<const MeasuredErrors*>& rows, double error,
                      double time, const std::string& what, Integrator integrator) {
  for (const MeasuredErrors* row : rows) {
    const auto found = steps_for_error(*row, error);
    if (found) {
      keep_smaller(choice, time / found->steps, explained(what, time, integrator, *found));
      continue;
    }
    choice.lacks = "the error of " + what + " with " + std::string(name_of(integrator)) +
                   " was not found to fall below " + brief(row->error.back());
    return;
  }
}

std::string not_measured(const std::string& what, Integrator integrator) {
  return "no errors were measured of " + what + " with " + std::string(name_of(integrator)) +
         "; a step in seconds or \"contact/N\"";
}

void choose_by_contacts(const Scene& scene, double error, const ClosingSpeeds& speeds, StepForError& choice) {
  for (const PossibleContact& contact : possible_contacts(scene)) {
    const Kind kind = kind_of(*contact.laws);
    if (!kind.lacks.empty()) {
      choice.lacks = kind.lacks + ", which " + contact.between + " have";
      return;
    }
    const ContactScale scale = scale_of(scene, contact, speeds);
    const double restitution = restitution_of(*contact.laws, scale);
    const auto rows = rows_about(kind.law, scene.run.integrator, restitution);
    const std::string what = "a contact of " + contact.between + " (" + std::string(name_of(kind.law)) +
                             ", restitution " + brief(restitution) + ")";
    if (rows.empty()) {
      choice.lacks = not_measured(what, scene.run.integrator);
      return;
    }
    keep_smallest_of(choice, rows, error, scale.duration, what, scene.run.integrator);
    if (!choice.lacks.empty()) return;
  }
}

void choose_by_drag(const Scene& scene, double error, StepForError& choice) {
  double rate = 0.0;
  for (const Particle& particle : scene.particles)
    if (!particle.fixed)
      rate = std::max(rate,
                      drag_rate(scene.flow, scene.materials[particle.material].density, particle.diameter));
  if (rate == 0.0) return;
  const auto rows = rows_about(ErrorLaw::drag, scene.run.integrator, 1.0);
  if (rows.empty() && choice.lacks.empty()) choice.lacks = not_measured("drag", scene.run.integrator);
  keep_smallest_of(choice, rows, error, 1.0 / rate, "drag's relaxation", scene.run.integrator);
}

}  // namespace

std::string_view name_of(ErrorLaw law) {
  switch (law) {
    case ErrorLaw::linear:
      return "linear";
    case ErrorLaw::no_tension:
      return "no_tension";
    case ErrorLaw::linear_history:
      return "linear_history";
    case ErrorLaw::hertz:
      return "hertz";
    case ErrorLaw::hertz_history:
      return "hertz_history";
    case ErrorLaw::drag:
      return "drag";
  }
  return "unknown";
}

std::optional<StepsForError> steps_for_error(const MeasuredErrors& measured, double error) {
  const auto& errors = measured.error;
  constexpr std::size_t last = measured_at.size() - 1;
  const auto through = [&](std::size_t coarse, std::size_t fine) {
    const double order = std::max(
        0.1, std::log(errors[coarse] / errors[fine]) / std::log(measured_at[fine] / measured_at[coarse]));
    const double constant = errors[fine] * std::pow(measured_at[fine], order);
    return StepsForError{std::pow(constant / error, 1.0 / order), constant, order};
  };
  if (errors[last] > error) {
    const StepsForError beyond = through(last - 2, last);
    return beyond.order < least_order ? std::nullopt : std::optional(beyond);
  }
  for (std::size_t i = last; i > 0; --i)
    if (errors[i - 1] > error) return through(i - 1, i);
  return StepsForError{measured_at.front(), errors.front(), 0.0};
}

StepForError step_for_error(const Scene& scene, double error, std::optional<double> impact_speed) {
  StepForError choice;
  choose_by_contacts(scene, error, ClosingSpeeds(scene, impact_speed), choice);
  choose_by_drag(scene, error, choice);
  if (choice.step == 0.0 && choice.lacks.empty())
    choice.lacks = "nothing in this scene makes an error of the step";
  const StepLimit limit = stability_limit(scene, impact_speed);
  if (limit.step == 0.0) choice.lacks = "no step is stable: " + limit.because;
  if (!choice.lacks.empty()) return choice;
  keep_smaller(choice, safe_share * limit.step,
               brief(100.0 * safe_share) + " % of the stability limit of " + limit.because);
  choice.because = "error " + brief(error) + ": " + choice.because;
  return choice;
}

}  // namespace grainproof::analytic
