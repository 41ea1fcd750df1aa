// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/common/kept_rows.hpp"
#include "benchmarks/common/row_pool.hpp"

namespace grainproof::bench {

/// A long table of rows that no time decides: measured on several threads, kept as it grows, with a line now
/// and then that tells how far it has come.
class RowTable {
 public:
  struct Row {
    std::string name;
    double weight;  ///< about how long it takes against the others
    std::function<MeasuredRow()> measure;
  };

  /// `what` is the table's name in what is told. Nothing begins before the first show().
  RowTable(std::string what, std::filesystem::path file, std::string stamp)
      : what_(std::move(what)), file_(std::move(file)), stamp_(std::move(stamp)) {}

  /// Returns its number.
  std::size_t add(Row row);

  /// Measured now, before, or by a program that was killed. With `threads` of 0 no other row is begun.
  MeasuredRow show(std::size_t row, std::size_t threads);

 private:
  void begin(std::size_t threads);
  MeasuredRow measure(std::size_t row) const;
  void tell();

  using Clock = std::chrono::steady_clock;

  std::string what_;
  std::filesystem::path file_;
  std::string stamp_;
  std::vector<Row> rows_;
  std::size_t shown_ = 0, known_ = 0;
  double weight_to_measure_ = 0.0, weight_measured_ = 0.0;
  Clock::time_point began_, told_;
  std::unique_ptr<KeptRows> kept_;
  std::unique_ptr<RowPool> pool_;  ///< last, so that its threads end before what they use
};

}  // namespace grainproof::bench
