// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ostream>

#include "report/text_table.hpp"

namespace grainproof::app {

/// Where results go (`out`) and where everything else goes (`err`).
struct Terminal {
  std::ostream& out;
  std::ostream& err;
  bool out_is_terminal = false;
  bool err_is_terminal = false;
  bool quiet = false;

  report::Paint paint() const { return {out_is_terminal}; }
};

}  // namespace grainproof::app
