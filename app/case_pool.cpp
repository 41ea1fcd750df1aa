// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/case_pool.hpp"

#include <algorithm>
#include <utility>

namespace grainproof::app {

CasePool::CasePool(std::size_t cases, std::size_t threads, JudgeCase judge)
    : judge_(std::move(judge)), slots_(cases) {
  for (std::size_t k = 0; k < std::min(cases, std::max<std::size_t>(threads, 1)); ++k)
    threads_.emplace_back([this] { work(); });
}

CasePool::~CasePool() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  for (std::thread& thread : threads_) thread.join();
}

void CasePool::work() {
  while (true) {
    std::size_t index = 0;
    {
      const std::lock_guard lock(mutex_);
      if (stopping_ || begun_ == slots_.size()) return;
      index = begun_++;
    }
    judge_into(index);
  }
}

void CasePool::judge_into(std::size_t index) {
  std::vector<Row> rows;
  std::exception_ptr failure;
  try {
    rows = judge_(index, [&](Event event) {
      const std::lock_guard lock(mutex_);
      slots_[index].told.push_back(std::move(event));
      news_.notify_one();
    });
  } catch (...) {
    failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  slots_[index].rows = std::move(rows);
  slots_[index].failure = failure;
  slots_[index].done = true;
  news_.notify_one();
}

std::vector<Event> CasePool::wait_for_news(Slot& slot, bool& done) {
  std::unique_lock lock(mutex_);
  news_.wait(lock, [&] { return slot.done || !slot.told.empty(); });
  done = slot.done;
  return std::exchange(slot.told, {});
}

std::vector<Row> CasePool::next(Progress& progress) {
  Slot& slot = slots_.at(given_++);
  for (bool done = false; !done;)
    for (const Event& event : wait_for_news(slot, done)) event(progress);
  if (slot.failure) std::rethrow_exception(slot.failure);
  return std::move(slot.rows);
}

std::size_t usual_threads() {
  return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 4);
}

}  // namespace grainproof::app
