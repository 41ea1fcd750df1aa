// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "device_fixture.hpp"
#include "opencl/bytes.hpp"
#include "opencl/scan.hpp"

namespace grainproof::opencl::testing {
namespace {

/// Counts that repeat only after a long while, zeros among them.
std::vector<cl_int> counts(std::size_t n) {
  std::vector<cl_int> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = static_cast<cl_int>(i * 2654435761u >> 7 & 15u);
  return values;
}

std::vector<cl_int> scanned(const std::vector<cl_int>& values, std::size_t work_group) {
  const EngineOptions options = options_for(Precision::single_precision);
  Workshop workshop(options.device, options.kernels);
  Program& program = workshop.program(BuildOptions{Precision::single_precision});
  Scan scan(workshop, program, values.size(), work_group);
  const cl::Buffer in = workshop.upload(bytes_of(values));
  const cl::Buffer out = workshop.upload(Bytes(values.size() * sizeof(cl_int), std::byte{0xff}));
  scan.exclusive(in, out, values.size());
  std::vector<cl_int> starts(values.size());
  workshop.read(out, std::as_writable_bytes(std::span(starts)));
  return starts;
}

std::vector<cl_int> expected(const std::vector<cl_int>& values) {
  std::vector<cl_int> starts(values.size());
  std::exclusive_scan(values.begin(), values.end(), starts.begin(), 0);
  return starts;
}

TEST(Scan, EqualsTheSerialOneAroundEveryMultipleOfABlock) {
  for (const std::size_t block : {16u * 8u, 16u * 8u * 16u * 8u})
    for (const std::size_t n : {block - 1, block, block + 1, 3 * block - 1, 3 * block, 3 * block + 1})
      EXPECT_EQ(scanned(counts(n), 16), expected(counts(n))) << n;
}

TEST(Scan, EqualsTheSerialOneForAFewValues) {
  for (std::size_t n = 1; n < 20; ++n) EXPECT_EQ(scanned(counts(n), 64), expected(counts(n))) << n;
}

TEST(Scan, EqualsTheSerialOneForMillions) {
  EXPECT_EQ(scanned(counts(5'000'011), 64), expected(counts(5'000'011)));
}

TEST(Scan, WorksInGroupsOfOne) {
  EXPECT_EQ(scanned(counts(1000), 1), expected(counts(1000)));
}

}  // namespace
}  // namespace grainproof::opencl::testing
