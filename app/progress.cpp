// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/progress.hpp"

#include <algorithm>
#include <cmath>

#include "report/numbers.hpp"

namespace grainproof::app {
namespace {

constexpr int bar_width = 24;
constexpr auto between_redraws = std::chrono::milliseconds(150);

std::string bar(double share) {
  const int full = static_cast<int>(std::lround(share * bar_width));
  std::string text;
  for (int i = 0; i < bar_width; ++i) text += i < full ? "█" : "·";
  return text;
}

}  // namespace

void Progress::begin() {
  began_ = Clock::now();
}

void Progress::show(const std::string& what, double share) {
  const auto now = Clock::now();
  if (!terminal_ || (shown_ && now - last_ < between_redraws)) return;
  const double done = std::clamp(share, 0.0, 1.0);
  const double spent = std::chrono::duration<double>(now - began_).count();
  stream_ << "\r\033[K" << bar(done) << " " << std::lround(100.0 * done) << " %  " << what;
  if (done > 0.01 && spent > 1.0)
    stream_ << ", " << report::duration(spent * (1.0 - done) / done) << " to go";
  stream_ << std::flush;
  shown_ = true;
  last_ = now;
}

void Progress::clear() {
  if (shown_) stream_ << "\r\033[K" << std::flush;
  shown_ = false;
}

void Progress::say(const std::string& line) {
  if (quiet_) return;
  clear();
  stream_ << line << std::endl;
}

}  // namespace grainproof::app
