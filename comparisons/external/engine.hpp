// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mutex>
#include <string>

#include "model/engine.hpp"

namespace grainproof {

/// A user's own code: `COMMAND SCENE.json FOLDER` is run by the shell in the current folder and writes
/// FOLDER/frames.csv. docs/external.md has the formats and a worked example.
class ExternalEngine : public Engine {
 public:
  explicit ExternalEngine(std::string command);

  std::string name() const override { return "external:" + command_; }
  /// Only the ledger is known to be beyond it; a command that cannot do a scene fails.
  Support supports(const Scene& scene, const Request& request) const override;
  /// One command at a time, since it may write where it likes.
  /// Exit status 3 is a run that went wrong, any other but 0 an EngineFailed with the last output.
  Observations observe(const Scene& scene, const Request& request) override;

 private:
  std::string command_;
  std::mutex turn_;
};

}  // namespace grainproof
