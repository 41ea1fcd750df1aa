// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/sources.hpp"

#include <fstream>
#include <sstream>

#include "model/errors.hpp"

namespace grainproof::opencl {

std::string assembled_source(const std::filesystem::path& folder, const std::vector<std::string>& files) {
  std::ostringstream source;
  for (const std::string& file : files) {
    const auto path = folder / file;
    std::ifstream stream(path);
    if (!stream) throw EngineFailed("cannot read kernel file " + path.string());
    source << "#line 1 \"" << path.string() << "\"\n" << stream.rdbuf() << '\n';
  }
  return source.str();
}

}  // namespace grainproof::opencl
