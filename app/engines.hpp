// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "model/engine.hpp"

namespace grainproof::app {

/// What an engine may need to be made.
struct EngineSettings {
  std::filesystem::path data;  ///< folder with kernels/
  std::string precision;       ///< empty takes every precision that was verified
  std::string device;          ///< empty takes the first GPU, else the processor
};

/// An engine that was asked for, or why there is none.
struct Made {
  std::string name;
  std::unique_ptr<Engine> engine;  ///< null where it is not available here
  std::string because;             ///< why not
  bool peer = false;
};

/// Engines by a name of the command line: "reference", "opencl" (all precisions), "opencl:mixed",
/// "analytic", "liggghts", "lammps", "external:COMMAND". Throws InputRefused for a name that is not known,
/// with those that are. What is known but not here (no device, not installed) is a Made without engine.
std::vector<Made> make_engines(const std::string& name, const EngineSettings& settings);

/// As make_engines, for one that has to run: throws InputRefused where it is not available.
/// A name that means several takes the first: "opencl" is single precision.
std::unique_ptr<Engine> make_engine(const std::string& name, const EngineSettings& settings);

/// What `verify` asks when nobody says otherwise.
std::vector<std::string> engines_to_verify();

/// Every name that engines go by, as it stands before a colon.
std::vector<std::string_view> engine_names();

/// A line a name, for --help.
std::string engine_help();

}  // namespace grainproof::app
