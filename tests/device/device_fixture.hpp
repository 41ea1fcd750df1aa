// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include "opencl/engine.hpp"

namespace grainproof::opencl::testing {

/// An engine with the kernels of the source tree.
EngineOptions options_for(Precision precision);

/// Frames of `scene`, which must complete.
Observations observed(const EngineOptions& options, const Scene& scene, const Request& request = {});

inline constexpr double single_roundoff = 0x1p-24;
inline constexpr double double_roundoff = 0x1p-53;

constexpr double roundoff(Precision precision) {
  return precision == Precision::double_precision ? double_roundoff : single_roundoff;
}

inline std::string precision_name(const ::testing::TestParamInfo<Precision>& info) {
  return std::string(name_of(info.param));
}

}  // namespace grainproof::opencl::testing

#define GRAINPROOF_IN_EVERY_PRECISION(fixture)                                                              \
  INSTANTIATE_TEST_SUITE_P(Precisions, fixture, ::testing::ValuesIn(::grainproof::opencl::every_precision), \
                           ::grainproof::opencl::testing::precision_name)

// Where many kernels are compiled and no law depends on how positions are held.
#define GRAINPROOF_IN_SINGLE_AND_DOUBLE(fixture)                                                 \
  INSTANTIATE_TEST_SUITE_P(Precisions, fixture,                                                  \
                           ::testing::Values(::grainproof::opencl::Precision::single_precision,  \
                                             ::grainproof::opencl::Precision::double_precision), \
                           ::grainproof::opencl::testing::precision_name)
