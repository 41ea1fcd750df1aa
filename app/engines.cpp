// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/engines.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "analytic/closed_forms.hpp"
#include "comparisons/external/engine.hpp"
#include "comparisons/lammps/engine.hpp"
#include "comparisons/liggghts/engine.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"
#include "opencl/engine.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::app {
namespace {

/// What follows the colon of a name: a precision, a command; empty where there is no colon.
using Rest = const std::string&;

std::vector<Made> one(Made made) {
  std::vector<Made> all;
  all.push_back(std::move(made));
  return all;
}

std::vector<Made> make_reference(Rest, const EngineSettings&) {
  return one({"reference", std::make_unique<reference::ReferenceEngine>(), "", false});
}

std::vector<Made> make_analytic(Rest rest, const EngineSettings&) {
  auto engine = rest.empty() ? analytic::make_analytic_engine() : analytic::make_closed_form(rest);
  return one({engine->name(), std::move(engine), "", false});
}

opencl::Precision precision_named(const std::string& name) {
  if (const auto precision = opencl::precision_named(name)) return *precision;
  throw InputRefused("no precision " + name + "; opencl has single, mixed and double");
}

Made make_opencl_in(const std::string& precision, const EngineSettings& settings) {
  opencl::EngineOptions options;
  options.precision = precision_named(precision);
  options.device = settings.device;
  options.kernels = settings.data / "kernels";
  const std::string name = "opencl:" + precision;
  try {
    return {name, std::make_unique<opencl::OpenClEngine>(std::move(options)), "", false};
  } catch (const EngineFailed& failure) {
    if (!settings.device.empty() && !opencl::list_devices().empty()) throw InputRefused(failure.what());
    return {name, nullptr, failure.what(), false};
  }
}

std::vector<Made> make_opencl(Rest rest, const EngineSettings& settings) {
  const std::string& wanted = rest.empty() ? settings.precision : rest;
  if (!wanted.empty()) return one(make_opencl_in(wanted, settings));
  std::vector<Made> all;
  for (const opencl::Precision precision : opencl::every_precision)
    all.push_back(make_opencl_in(std::string(name_of(precision)), settings));
  return all;
}

std::vector<Made> make_liggghts(Rest, const EngineSettings&) {
  if (!find_program("liggghts"))
    return one({"liggghts", nullptr, "not installed; on Debian: apt-get install liggghts", true});
  return one({"liggghts", std::make_unique<LiggghtsEngine>(), "", true});
}

std::vector<Made> make_lammps(Rest, const EngineSettings&) {
  if (!find_program("lmp"))
    return one({"lammps", nullptr, "not installed; on Debian: apt-get install lammps", true});
  return one({"lammps", std::make_unique<LammpsEngine>(), "", true});
}

std::vector<Made> make_external(Rest command, const EngineSettings&) {
  if (command.empty()) throw InputRefused("engine external; expected external:COMMAND");
  return one({"external:" + command, std::make_unique<ExternalEngine>(command), "", true});
}

/// By hand, a row a name of the command line.
struct Known {
  std::string_view name;
  std::string_view what;
  bool takes_rest;       ///< "name:rest" has a meaning
  bool takes_precision;  ///< --precision has a meaning
  bool verified;         ///< asked by a verify that names no engines
  std::vector<Made> (*make)(Rest rest, const EngineSettings& settings);
};

constexpr std::array known{
    Known{"reference", "serial, double precision", false, false, true, make_reference},
    Known{"opencl", "all precisions, or opencl:single, opencl:mixed, opencl:double", true, true, true,
          make_opencl},
    Known{"analytic", "the closed form that fits, or analytic:NAME", true, false, false, make_analytic},
    Known{"liggghts", "the installed LIGGGHTS", false, false, true, make_liggghts},
    Known{"lammps", "the installed LAMMPS", false, false, true, make_lammps},
    Known{"external", "external:COMMAND, a program of your own (docs/external.md)", true, false, false,
          make_external},
};

std::string known_names() {
  std::string names;
  for (const Known& row : known) names += (names.empty() ? "" : ", ") + std::string(row.name);
  return names;
}

}  // namespace

std::vector<Made> make_engines(const std::string& name, const EngineSettings& settings) {
  const std::size_t colon = name.find(':');
  const std::string rest = colon == std::string::npos ? "" : name.substr(colon + 1);
  const auto row = std::find_if(known.begin(), known.end(),
                                [&](const Known& one) { return one.name == name.substr(0, colon); });
  if (row == known.end()) throw InputRefused("unknown engine " + name + "; known are " + known_names());
  if (!rest.empty() && !row->takes_rest)
    throw InputRefused("unknown engine " + name + "; expected " + std::string(row->name) + " alone");
  if (!settings.precision.empty() && !row->takes_precision)
    throw InputRefused("found --precision " + settings.precision + " with engine " + name +
                       "; only opencl has a choice");
  return row->make(rest, settings);
}

std::unique_ptr<Engine> make_engine(const std::string& name, const EngineSettings& settings) {
  Made made = std::move(make_engines(name, settings).front());
  if (!made.engine) throw InputRefused(made.name + " is not available: " + made.because);
  return std::move(made.engine);
}

std::vector<std::string> engines_to_verify() {
  std::vector<std::string> names;
  for (const Known& row : known)
    if (row.verified) names.emplace_back(row.name);
  return names;
}

std::vector<std::string_view> engine_names() {
  std::vector<std::string_view> names;
  for (const Known& row : known) names.push_back(row.name);
  return names;
}

std::string engine_help() {
  std::string text = "Engines:";
  for (const Known& row : known) text += "\n  " + std::string(row.name) + ": " + std::string(row.what);
  return text;
}

}  // namespace grainproof::app
