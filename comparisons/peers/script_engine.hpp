// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "model/engine.hpp"

namespace grainproof::peers {

/// What one of the programs has of its own.
struct Dialect {
  std::string name;            ///< as the command line spells it
  std::string called;          ///< in messages
  std::string package;         ///< Debian's
  std::string version_before;  ///< stands before the version in the first line of output
  Support (*expressible)(const Scene& scene, const Request& request);
  /// Writes the other files of a scene into `folder` and returns its commands.
  std::string (*deck)(const Scene& scene, const Request& request, const std::filesystem::path& folder,
                      int number);
  std::string (*variant)(const Scene& scene);  ///< for Provenance::variant
};

struct ProgramOptions {
  std::string program;
  int processes = 1;  ///< above 1 through mpirun, for scenes of 1000 particles or more
};

/// A program that reads a deck: writes one for a scene, runs it in a private folder, reads the dump. Many
/// scenes go into one process.
class ScriptEngine : public Engine {
 public:
  ScriptEngine(Dialect dialect, ProgramOptions options);

  std::string name() const override { return dialect_.name; }
  Support supports(const Scene& scene, const Request& request) const override;
  /// Throws EngineFailed with what the program said last.
  Observations observe(const Scene& scene, const Request& request) override;
  std::vector<Observations> observe_all(std::span<const Scene> scenes, const Request& request) override;

 private:
  std::vector<Observations> observe_batch(std::span<const Scene> scenes, const Request& request) const;
  std::vector<std::string> command(std::span<const Scene> scenes) const;
  std::string version_in(const std::filesystem::path& output) const;
  Provenance provenance_of(const Scene& scene, const std::string& version) const;

  Dialect dialect_;
  ProgramOptions options_;
  bool installed_;
};

}  // namespace grainproof::peers
