// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_process.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>

namespace grainproof::opencl::testing {

Finished run_driver(const std::string& prefix, const std::string& arguments) {
  const std::string command = prefix + " " GRAINPROOF_DEVICE_DRIVER " " + arguments + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {-1, "cannot start: " + command};
  std::string output;
  std::array<char, 4096> chunk{};
  while (std::fgets(chunk.data(), chunk.size(), pipe) != nullptr) output += chunk.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

}  // namespace grainproof::opencl::testing
