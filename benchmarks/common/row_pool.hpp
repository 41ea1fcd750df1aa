// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "benchmarks/common/kept_rows.hpp"

namespace grainproof::bench {

/// Measures the rows of a table on several threads, in their order and ahead of who asks for them. Only for
/// rows that no time decides.
class RowPool {
 public:
  /// Must not throw: what went wrong is the row's `failed`.
  using Measure = std::function<MeasuredRow(std::size_t row)>;

  /// Without threads a row is measured when it is asked for, and no other.
  RowPool(std::size_t rows, std::size_t threads, Measure measure);
  /// Waits for the rows that are being measured and begins no other.
  ~RowPool();
  RowPool(const RowPool&) = delete;
  RowPool& operator=(const RowPool&) = delete;

  MeasuredRow wait_for(std::size_t row);

 private:
  void work();

  Measure measure_;
  std::mutex mutex_;  ///< guards all below but the threads
  std::condition_variable news_;
  std::vector<std::optional<MeasuredRow>> rows_;
  std::size_t begun_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace grainproof::bench
