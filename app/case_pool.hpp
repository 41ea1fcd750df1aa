// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "app/progress.hpp"
#include "comparisons/verdict.hpp"

namespace grainproof::app {

/// Something to be shown when the turn of its case comes; only one thread ever shows.
using Event = std::function<void(Progress&)>;
using Tell = std::function<void(Event)>;
using JudgeCase = std::function<std::vector<Row>(std::size_t index, const Tell& tell)>;

/// Judges cases on several threads at once and gives their rows in the order of the cases, with what was told
/// on the way, so that nothing that is shown or written depends on which case ended first.
class CasePool {
 public:
  CasePool(std::size_t cases, std::size_t threads, JudgeCase judge);
  /// Waits for the cases that are being judged and begins no other.
  ~CasePool();
  CasePool(const CasePool&) = delete;
  CasePool& operator=(const CasePool&) = delete;

  /// Waits for the next case. Throws what judging it threw.
  std::vector<Row> next(Progress& progress);

 private:
  struct Slot {
    std::vector<Event> told;
    std::vector<Row> rows;
    std::exception_ptr failure;
    bool done = false;
  };

  void work();
  void judge_into(std::size_t index);
  std::vector<Event> wait_for_news(Slot& slot, bool& done);

  JudgeCase judge_;
  std::mutex mutex_;  ///< guards all below but the threads
  std::condition_variable news_;
  std::vector<Slot> slots_;
  std::size_t begun_ = 0, given_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

/// Threads for a pool where nobody says: a core each, and no more than four, for peers are processes beside
/// them.
std::size_t usual_threads();

}  // namespace grainproof::app
