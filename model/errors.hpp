// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace grainproof {

/// The input was refused before anything ran; exit code 2. `what()` is the whole message:
/// "FILE:LINE:COLUMN: found …; expected …" where there is a file.
class InputRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run went wrong; exit code 3. Thrown by Run::advance, turned into an Outcome by observe().
class RunWentWrong : public std::runtime_error {
 public:
  RunWentWrong(const std::string& cause, std::int64_t at_step, double at_time, std::vector<std::int64_t> ids)
      : std::runtime_error(cause), step(at_step), time(at_time), particles(std::move(ids)) {}

  std::int64_t step;
  double time;  ///< s
  std::vector<std::int64_t> particles;
};

/// An engine, a device or a peer program failed by itself: not installed, crashed, would not build.
class EngineFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace grainproof
