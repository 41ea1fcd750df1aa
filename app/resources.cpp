// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/resources.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "input/text.hpp"
#include "model/errors.hpp"

namespace grainproof::app {
namespace fs = std::filesystem;
namespace {

bool holds_data(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder / "kernels", ignored) && fs::is_directory(folder / "scenes", ignored);
}

fs::path named_by_environment(const char* named) {
  if (holds_data(named)) return fs::absolute(named);
  throw InputRefused("GRAINPROOF_DATA is " + std::string(named) +
                     "; expected a folder with kernels/ and scenes/");
}

[[noreturn]] void refuse_name(const std::string& wanted, const std::vector<fs::path>& known) {
  if (wanted.find('/') != std::string::npos || wanted.ends_with(".toml"))
    throw InputRefused("no file " + wanted +
                       "; expected a scene file, or a name that grainproof verify --list has");
  std::vector<std::string> names;
  for (const fs::path& path : known) names.push_back(path.stem().string());
  const std::string_view near = input::nearest(wanted, {names.begin(), names.end()});
  throw InputRefused("no case " + wanted + "; expected " +
                     (near.empty() ? "one" : std::string(near) + ", or another") + " of the " +
                     std::to_string(names.size()) + " that grainproof verify --list names, or a scene file");
}

}  // namespace

fs::path data_root() {
  if (const char* named = std::getenv("GRAINPROOF_DATA"); named != nullptr && *named != '\0')
    return named_by_environment(named);
  const fs::path executable = fs::read_symlink("/proc/self/exe");
  const fs::path installed = executable.parent_path().parent_path() / "share" / "grainproof";
  if (holds_data(installed)) return installed;
  for (fs::path above = executable.parent_path(); above != above.root_path(); above = above.parent_path())
    if (holds_data(above)) return above;
  throw InputRefused("no folder with kernels/ and scenes/ beside or above " + executable.string() +
                     "; set GRAINPROOF_DATA to the one to use");
}

std::vector<fs::path> known_cases(const fs::path& root) {
  std::vector<fs::path> cases;
  for (const auto& entry : fs::recursive_directory_iterator(root / "scenes"))
    if (entry.path().extension() == ".toml") cases.push_back(entry.path());
  std::sort(cases.begin(), cases.end(),
            [](const fs::path& a, const fs::path& b) { return a.stem() < b.stem(); });
  return cases;
}

fs::path find_case(const fs::path& root, const std::string& name_or_path) {
  if (fs::is_regular_file(name_or_path)) return name_or_path;
  const std::vector<fs::path> known = known_cases(root);
  for (const fs::path& path : known)
    if (path.stem() == name_or_path) return path;
  refuse_name(name_or_path, known);
}

}  // namespace grainproof::app
