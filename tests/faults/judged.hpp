// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "analytic/closed_forms.hpp"
#include "comparisons/judge.hpp"
#include "input/read_case.hpp"
#include "reference_cpu/reference_engine.hpp"

namespace grainproof::faults {

/// The exact answers that scene files name: closed forms and the reference.
class Exact {
 public:
  Engine* operator()(const std::string& against) {
    std::unique_ptr<Engine>& known = engines_[against];
    if (!known) known = make(against);
    return known.get();
  }

 private:
  static std::unique_ptr<Engine> make(const std::string& against) {
    const std::string form = "closed_form:";
    if (against.rfind(form, 0) == 0) return analytic::make_closed_form(against.substr(form.size()));
    if (against == "engine:reference") return std::make_unique<reference::ReferenceEngine>();
    return nullptr;
  }

  std::map<std::string, std::unique_ptr<Engine>> engines_;
};

/// The scene file of a case, in whichever folder of scenes/ it is.
inline std::filesystem::path case_file(const std::string& name) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator("scenes"))
    if (entry.path().stem() == name && entry.path().extension() == ".toml") return entry.path();
  throw std::runtime_error("there is no case " + name);
}

/// By the first `samples` of the case's sweep, or by all where that is 0, of the scenes that are `taken`.
inline std::vector<Row> judged(
    const std::filesystem::path& scene, Engine& engine, int samples = 0,
    const std::function<bool(const Scene&)>& taken = [](const Scene&) { return true; }) {
  const auto exact = std::make_shared<Exact>();
  Case subject = read_case(scene, {});
  if (samples > 0)
    std::erase_if(subject.scenes, [&](const ResolvedScene& one) { return one.point.sample >= samples; });
  std::erase_if(subject.scenes, [&](const ResolvedScene& one) { return !taken(one.scene); });
  return judge(subject, engine, [exact](const std::string& against) { return (*exact)(against); });
}

inline std::vector<Row> failed(const std::vector<Row>& rows) {
  std::vector<Row> failures;
  for (const Row& row : rows)
    if (row.verdict == Verdict::fail) failures.push_back(row);
  return failures;
}

}  // namespace grainproof::faults
