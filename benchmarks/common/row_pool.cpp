// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/row_pool.hpp"

#include <utility>

namespace grainproof::bench {

RowPool::RowPool(std::size_t rows, std::size_t threads, Measure measure)
    : measure_(std::move(measure)), rows_(rows) {
  for (std::size_t k = 0; k < threads; ++k) threads_.emplace_back([this] { work(); });
}

RowPool::~RowPool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  for (std::thread& thread : threads_) thread.join();
}

void RowPool::work() {
  while (true) {
    std::size_t row = 0;
    {
      const std::lock_guard lock(mutex_);
      if (stopping_ || begun_ == rows_.size()) return;
      row = begun_++;
    }
    MeasuredRow measured = measure_(row);
    const std::lock_guard lock(mutex_);
    rows_[row] = std::move(measured);
    news_.notify_all();
  }
}

MeasuredRow RowPool::wait_for(std::size_t row) {
  if (threads_.empty()) return measure_(row);
  std::unique_lock lock(mutex_);
  news_.wait(lock, [&] { return rows_.at(row).has_value(); });
  return *rows_[row];
}

}  // namespace grainproof::bench
