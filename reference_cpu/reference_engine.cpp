// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/reference_engine.hpp"

#include "model/errors.hpp"
#include "reference_cpu/reference_run.hpp"
#include "reference_cpu/supports.hpp"

namespace grainproof::reference {

Support ReferenceEngine::supports(const Scene& scene, const Request& request) const {
  if (request.ledger && scene.run.integrator == Integrator::pefrl)
    return Support::no(
        "the ledger needs forces at the boundary of a step, where pefrl evaluates none; take "
        "velocity_verlet");
  return supported(scene);
}

std::unique_ptr<Run> ReferenceEngine::start(const Scene& scene, const Request& request) {
  if (const Support support = supports(scene, request); !support) throw InputRefused(support.because);
  return std::make_unique<ReferenceRun>(scene, request.ledger);
}

std::unique_ptr<RestartableRun> ReferenceEngine::restored(const Scene& scene, const Request& request,
                                                          const Checkpoint& from, std::string& because) {
  if (from.maker != checkpoint_maker) {
    because =
        "it was written by " + (from.maker.empty() ? "an engine without a part of its own" : from.maker);
    return nullptr;
  }
  if (request.ledger && !from.ledger) {
    because = "it was written by a run without a ledger";
    return nullptr;
  }
  auto run = std::make_unique<ReferenceRun>(scene, request.ledger);
  run->restore(from.own);
  return run;
}

std::unique_ptr<RestartableRun> ReferenceEngine::go_on(const Scene& scene, const Request& request,
                                                       const Beginning& beginning) {
  return std::make_unique<ReferenceRun>(scene, request.ledger, beginning);
}

Provenance ReferenceEngine::provenance() const {
  return {.engine = name(),
          .precision = "double",
          .device = "one CPU core",
          .version = GRAINPROOF_VERSION,
          .variant = "",
          .unit_roundoff = 0x1p-53};
}

}  // namespace grainproof::reference
