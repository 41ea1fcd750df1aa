// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <ostream>
#include <string>

namespace grainproof::app {

/// What goes on, for a person: on a terminal one line rewritten a few times a second, elsewhere only
/// the lines of say(). Silent when quiet.
class Progress {
 public:
  Progress(std::ostream& stream, bool terminal, bool quiet)
      : stream_(stream), terminal_(terminal && !quiet), quiet_(quiet) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// A bar with the time still to go, estimated from the share done since begin().
  void show(const std::string& what, double share);
  void begin();
  /// Takes the bar off the terminal.
  void clear();
  /// A line that stays, on a terminal or not.
  void say(const std::string& line);

  bool on_terminal() const { return terminal_; }

 private:
  using Clock = std::chrono::steady_clock;
  std::ostream& stream_;
  bool terminal_;
  bool quiet_;
  bool shown_ = false;
  Clock::time_point began_ = Clock::now();
  Clock::time_point last_ = Clock::time_point::min();
};

}  // namespace grainproof::app
