// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/engine.hpp"

namespace grainproof::reference {

/// The serial engine: double throughout, one order of summation, plain to read. Every other engine
/// is held against it.
class ReferenceEngine : public SteppingEngine {
 public:
  std::string name() const override { return "reference"; }
  Support supports(const Scene& scene, const Request& request) const override;
  /// Throws InputRefused for a scene that it does not support.
  std::unique_ptr<Run> start(const Scene& scene, const Request& request) override;
  Provenance provenance() const override;
};

}  // namespace grainproof::reference
