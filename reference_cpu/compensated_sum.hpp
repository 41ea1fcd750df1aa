// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace grainproof::reference {

/// Kahan's sum: over very many equal terms a plain one drifts, as every addition rounds the same way.
template <class Value>
class CompensatedSum {
 public:
  explicit CompensatedSum(const Value& zero) : sum_(zero), lost_(zero) {}

  void add(const Value& term) {
    const Value owed = term - lost_;
    const Value next = sum_ + owed;
    lost_ = (next - sum_) - owed;
    sum_ = next;
  }

  const Value& value() const { return sum_; }

 private:
  Value sum_, lost_;
};

}  // namespace grainproof::reference
