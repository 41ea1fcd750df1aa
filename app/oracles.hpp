// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/engines.hpp"

namespace grainproof::app {

/// The engines that know the exact answer, by what a case writes in `against`: made when first asked for.
class OracleTable {
 public:
  explicit OracleTable(EngineSettings settings) : settings_(std::move(settings)) {}

  /// "closed_form:NAME" or "engine:NAME"; null where there is none of that name or it is not available.
  /// For several threads at once.
  Engine* find(const std::string& against);

 private:
  EngineSettings settings_;
  std::mutex mutex_;
  std::map<std::string, std::unique_ptr<Engine>> made_;
};

}  // namespace grainproof::app
