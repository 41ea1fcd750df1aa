// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "app/command_line.hpp"

int main(int argc, char** argv) {
  const bool colours = isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr;
  grainproof::app::Terminal terminal{std::cout, std::cerr, colours, isatty(STDERR_FILENO) != 0};
  return grainproof::app::run_command_line(argc, argv, terminal);
}
