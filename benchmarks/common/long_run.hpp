// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/common/long_scenes.hpp"
#include "model/checkpoint.hpp"

/// A run that may take an hour: what was seen of it and its checkpoint are kept in a folder, so that a
/// program that was killed goes on from there.
namespace grainproof::bench {

struct Window {
  std::int64_t step;  ///< at its end
  Seen mean, most;    ///< over the frames that were looked at
};

struct LongHistory {
  std::vector<Window> windows;
  std::string failed;          ///< what ended the run; empty where it went through
  std::int64_t failed_at = 0;  ///< step
  double wall_s = 0.0;         ///< of stepping and looking, over all programs that had a part in it
  bool complete = false;
};

struct LongPlace {
  std::filesystem::path folder;
  std::string stamp;                 ///< of the program: what another one has left is not gone on from
  double checkpoint_seconds = 20.0;  ///< between two of them
};

/// Told after each window; false stops the run there, with a checkpoint.
using LongTick = std::function<bool(std::int64_t step)>;

/// Goes on from what the folder holds, else begins; returns at once where it holds all of it.
LongHistory long_run(RestartableEngine& engine, const LongPlan& plan, const LongPlace& place,
                     const LongTick& tick);

/// Of this program and its kernels: changes whenever one of them is made anew.
std::string program_stamp(const std::filesystem::path& kernels);

}  // namespace grainproof::bench
