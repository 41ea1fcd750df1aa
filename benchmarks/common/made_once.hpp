// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <exception>
#include <map>
#include <mutex>
#include <optional>

namespace grainproof::bench {

/// Values that take long to make: each by the first thread that asks for it, while others go on unless they
/// ask for the same. What it gives stays where it is.
template <class Key, class Value>
class MadeOnce {
 public:
  template <class Make>
  const Value& get(const Key& key, const Make& make) {
    Entry& entry = entry_of(key);
    const std::lock_guard lock(entry.mutex);
    if (entry.failure) std::rethrow_exception(entry.failure);
    try {
      if (!entry.value) entry.value.emplace(make());
    } catch (...) {
      entry.failure = std::current_exception();
      throw;
    }
    return *entry.value;
  }

 private:
  struct Entry {
    std::mutex mutex;
    std::optional<Value> value;
    std::exception_ptr failure;
  };

  Entry& entry_of(const Key& key) {
    const std::lock_guard lock(mutex_);
    return entries_[key];
  }

  std::mutex mutex_;
  std::map<Key, Entry> entries_;
};

}  // namespace grainproof::bench
