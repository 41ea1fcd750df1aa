// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

/// A table that takes long: what has been measured of it is kept in a file, a line a row, so that a program
/// that was killed goes on from there.
namespace grainproof::bench {

struct MeasuredRow {
  std::map<std::string, double> values;
  std::string failed;  ///< why there are none
};

class KeptRows {
 public:
  /// Reads what `file` holds. `stamp` is of the program and its settings: what another has left is dropped,
  /// and so are lines that were not finished.
  KeptRows(std::filesystem::path file, std::string stamp);

  const std::map<std::string, MeasuredRow>& found() const { return found_; }
  /// Lines of another program or other settings.
  std::size_t dropped() const { return dropped_; }

  /// Written before it returns. A row that failed is not kept: it is to be tried again.
  void keep(const std::string& name, const MeasuredRow& row) const;
  /// All is shown: the next program begins anew.
  void remove() const;

 private:
  void read();
  void write_anew() const;

  std::filesystem::path file_;
  std::string stamp_;
  std::map<std::string, MeasuredRow> found_;
  std::size_t dropped_ = 0;
};

}  // namespace grainproof::bench
