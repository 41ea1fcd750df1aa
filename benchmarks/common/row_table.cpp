// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/row_table.hpp"

#include <iostream>

#include "report/numbers.hpp"

namespace grainproof::bench {
namespace {

constexpr std::chrono::seconds notes_every{30};

}  // namespace

std::size_t RowTable::add(Row row) {
  rows_.push_back(std::move(row));
  return rows_.size() - 1;
}

void RowTable::begin(std::size_t threads) {
  began_ = told_ = Clock::now();
  kept_ = std::make_unique<KeptRows>(file_, stamp_);
  for (const Row& row : rows_) {
    const bool known = kept_->found().contains(row.name);
    known_ += known;
    weight_to_measure_ += known ? 0.0 : row.weight;
  }
  if (kept_->dropped() > 0)
    std::cout << "note: " << what_ << ": " << kept_->dropped()
              << " rows of another program or other settings are not used" << std::endl;
  if (known_ > 0)
    std::cout << "note: " << what_ << " goes on after " << known_ << " of " << rows_.size() << " rows"
              << std::endl;
  pool_ = std::make_unique<RowPool>(rows_.size(), threads, [this](std::size_t row) { return measure(row); });
}

MeasuredRow RowTable::measure(std::size_t row) const {
  const auto known = kept_->found().find(rows_[row].name);
  if (known != kept_->found().end()) return known->second;
  MeasuredRow measured = rows_[row].measure();
  kept_->keep(rows_[row].name, measured);
  return measured;
}

MeasuredRow RowTable::show(std::size_t row, std::size_t threads) {
  if (!pool_) begin(threads);
  MeasuredRow found = pool_->wait_for(row);
  if (!kept_->found().contains(rows_[row].name)) weight_measured_ += rows_[row].weight;
  if (++shown_ == rows_.size())
    kept_->remove();
  else
    tell();
  return found;
}

void RowTable::tell() {
  const auto now = Clock::now();
  if (now - told_ < notes_every || weight_measured_ <= 0.0) return;
  told_ = now;
  const double spent = std::chrono::duration<double>(now - began_).count();
  std::cout << "note: " << what_ << ": " << shown_ << " of " << rows_.size() << ", "
            << report::duration(spent * (weight_to_measure_ / weight_measured_ - 1.0)) << " to go"
            << std::endl;
}

}  // namespace grainproof::bench
