// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "device_fixture.hpp"

#include <cstdlib>

namespace grainproof::opencl::testing {
namespace {

/// A cache of compiled kernels that no other program of the user shares.
const int private_cache = setenv("POCL_CACHE_DIR", GRAINPROOF_POCL_CACHE, 0);

}  // namespace

EngineOptions options_for(Precision precision) {
  EngineOptions options;
  options.precision = precision;
  const char* other = std::getenv("GRAINPROOF_TEST_KERNELS");
  options.kernels = other != nullptr ? other : GRAINPROOF_KERNELS;
  return options;
}

Observations observed(const EngineOptions& options, const Scene& scene, const Request& request) {
  OpenClEngine engine(options);
  Observations seen = engine.observe(scene, request);
  EXPECT_EQ(seen.outcome.status, Outcome::Status::completed) << seen.outcome.reason;
  return seen;
}

}  // namespace grainproof::opencl::testing
