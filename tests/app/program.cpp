// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/app/program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace grainproof::testing {
namespace fs = std::filesystem;

Ended run_program(const std::string& arguments, const std::string& environment) {
  const Scratch scratch;
  const std::string data = fs::current_path().string();
  const std::string command =
      "env GRAINPROOF_DATA='" + data + "' " + environment + " '" GRAINPROOF_PROGRAM "' " + arguments + " >'" +
      scratch.path("out").string() + "' 2>'" + scratch.path("err").string() + "' </dev/null";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(scratch.path("out")),
          text_of(scratch.path("err"))};
}

Scratch::Scratch() {
  std::string name = (fs::temp_directory_path() / "grainproof-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string Scratch::file(const std::string& name, const std::string& text) const {
  std::ofstream(path(name)) << text;
  return path(name).string();
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

nlohmann::json json_of(const fs::path& file) {
  return nlohmann::json::parse(text_of(file));
}

std::string falling_sphere(const std::string& wanted, const std::string& changed) {
  std::string text = R"(schema = 1
title = "A sphere falls onto a floor"
[run]
end = 0.2
step = "contact/32"
record = { every = 0.05 }
[domain]
lower = [-1.0, -1.0, -1.0]
upper = [1.0, 1.0, 1.0]
[material.glass]
density = 2000.0
[[contact]]
between = ["glass", "glass"]
normal = { law = "linear", stiffness = 1e5, restitution = 0.8 }
[[wall]]
name = "floor"
material = "glass"
plane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }
[[particles]]
material = "glass"
diameter = 0.1
positions = [[0.0, 0.0, 0.1]]
[field]
gravity = [0.0, 0.0, -9.81]
)";
  const std::size_t at = text.find(wanted);
  if (at == std::string::npos) throw std::runtime_error("the scene has no " + wanted);
  return text.replace(at, wanted.size(), changed);
}

std::string escaping_sphere() {
  return falling_sphere("positions = [[0.0, 0.0, 0.1]]",
                        "positions = [[0.55, 0.0, 0.5]]\nvelocities = [[4.0, 0.0, 0.0]]");
}

}  // namespace grainproof::testing
