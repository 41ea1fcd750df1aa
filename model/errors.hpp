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
  RunWentWrong(std::string cause, std::int64_t step, double time, std::vector<std::int64_t> particles)
      : std::runtime_error(std::move(cause)), step(step), time(time), particles(std::move(particles)) {}

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
