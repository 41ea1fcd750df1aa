// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "comparisons/judging/claims.hpp"

namespace grainproof {

/// Some scenes of a case, observed in one go with one request.
struct Chunk {
  Request request;
  std::vector<std::size_t> scenes;  ///< indices into Case::scenes, increasing
};

/// What the engines named in `against` saw at the sample times, by (against, scene).
using Records = std::map<std::pair<std::string, std::size_t>, Observations>;

/// Bytes of the frames of one observation.
std::size_t frame_bytes(const Scene& scene, const Request& request);

/// One observation a scene of the chunk; an engine that throws fails every scene with its message.
std::vector<Observations> observe_chunk(const Case& subject, const Chunk& chunk, Engine& engine);

/// The frames at the sample times only.
Observations thinned(const Scene& scene, const Observations& seen);

/// Empty where the run completed, has all its frames and only finite numbers, else what is wrong.
std::string fault_of(const Scene& scene, const Observations& seen);

/// The exact side of every claim for the scenes of one chunk.
class ExactSide {
 public:
  /// Observes the engines that the claims name, where `records` does not know their answer yet.
  ExactSide(const Case& subject, const Chunk& chunk, const std::vector<Claim>& claims, Records& records);

  /// `seen` is what the judged engine saw, whose frame times a closed form answers at. `at` counts
  /// within the chunk. A failure is an outcome.
  Observations of(const Claim& claim, std::size_t at, const Observations& seen) const;

 private:
  /// What all claims against one engine together need of it.
  struct Question {
    Engine* oracle = nullptr;
    bool every_step = false;
    bool ledger = false;
    std::set<std::size_t> scenes;
  };
  void ask(const std::string& against, const Question& question, Records& records);

  const Case& subject_;
  const Chunk& chunk_;
  std::map<std::string, std::map<std::size_t, Observations>> engines_;  ///< by `against` and scene
};

}  // namespace grainproof
