// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/checkpoint.hpp"

namespace grainproof::reference {

/// The serial engine: double throughout, one order of summation, plain to read. Every other engine
/// is held against it.
class ReferenceEngine : public RestartableEngine {
 public:
  std::string name() const override { return "reference"; }
  Support supports(const Scene& scene, const Request& request) const override;
  /// Throws InputRefused for a scene that it does not support.
  std::unique_ptr<Run> start(const Scene& scene, const Request& request) override;
  Provenance provenance() const override;

 protected:
  std::unique_ptr<RestartableRun> restored(const Scene& scene, const Request& request, const Checkpoint& from,
                                           std::string& because) override;
  std::unique_ptr<RestartableRun> go_on(const Scene& scene, const Request& request,
                                        const Beginning& beginning) override;
};

}  // namespace grainproof::reference
