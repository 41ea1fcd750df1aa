// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Mistakes planted in the reference and in the closed forms, one at a time. Each must be judged wrong by the
// case that is named with it, and without any of them that case must hold.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <compare>
#include <cstdio>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "opencl/engine.hpp"
#include "reference_cpu/reference_engine.hpp"
#include "tests/faults/judged.hpp"
#include "tests/faults/planted.hpp"

namespace grainproof::faults {

int planted = 0;

namespace {

struct HostFault {
  const char* name;
  const char* file;
  const char* scene;
  bool opencl;  ///< held against the reference

  auto operator<=>(const HostFault& other) const {
    return std::pair(std::string_view(scene), opencl) <=>
           std::pair(std::string_view(other.scene), other.opencl);
  }
};

constexpr HostFault faults[] = {
#include "host_fault_table.inc"
};

std::vector<Row> rows_of(int fault, const std::string& scene, Engine& engine) {
  planted = fault;
  auto rows = judged(case_file(scene), engine);
  planted = 0;
  return rows;
}

Engine& device() {
  static opencl::OpenClEngine engine([] {
    opencl::EngineOptions options;
    options.precision = opencl::Precision::double_precision;
    options.kernels = "kernels";
    return options;
  }());
  return engine;
}

/// The reference by itself, or the other engine, which is held against it.
std::vector<Row> rows_with(int number, const HostFault& fault) {
  reference::ReferenceEngine engine;
  return rows_of(number, fault.scene, fault.opencl ? device() : engine);
}

class HostFaults : public testing::TestWithParam<int> {};

TEST_P(HostFaults, AreNoticed) {
  const HostFault& fault = faults[GetParam() - 1];
  const auto rows = rows_with(GetParam(), fault);
  RecordProperty("case", fault.scene);
  RecordProperty("of", fault.file);
  EXPECT_FALSE(failed(rows).empty()) << "unnoticed by " << rows.size() << " rows of " << fault.scene;
}

INSTANTIATE_TEST_SUITE_P(Planted, HostFaults, testing::Range(1, static_cast<int>(std::size(faults)) + 1),
                         [](const auto& tested) { return std::string(faults[tested.param - 1].name); });

/// The control: the program that has all faults in it, and none planted.
TEST(NoFault, IsNoticedByThoseCases) {
  std::set<HostFault> different(std::begin(faults), std::end(faults));
  for (const HostFault& fault : different)
    for (const Row& row : failed(rows_with(0, fault)))
      ADD_FAILURE() << fault.scene << ": " << row.quantity << " at " << row.step << ": error " << row.error
                    << " " << row.reason;
}

using Clock = std::chrono::steady_clock;

double since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// Seconds above which a case is not asked for every fault.
constexpr double dear = 0.3;

/// The cases that the reference is judged by, the cheapest first.
std::multimap<double, std::string> cases_by_cost() {
  std::multimap<double, std::string> cases;
  reference::ReferenceEngine engine;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("scenes")) {
    if (entry.path().extension() != ".toml" || read_case(entry.path(), {}).tier != Tier::quick) continue;
    const auto began = Clock::now();
    const bool judges = !rows_of(0, entry.path().stem(), engine).empty();
    if (judges && since(began) < dear) cases.emplace(since(began), entry.path().stem());
  }
  return cases;
}

/// Not a test but an answer, for tests/faults/score.py: the cheapest case that catches each fault.
TEST(Panel, DISABLED_CheapestCaseOfEachFault) {
  const auto cases = cases_by_cost();
  reference::ReferenceEngine engine;
  for (int fault = 1; fault <= static_cast<int>(std::size(faults)); ++fault) {
    std::string cheapest = "-";
    for (const auto& [cost, name] : cases) {
      if (failed(rows_of(fault, name, engine)).empty()) continue;
      cheapest = name;
      break;
    }
    std::printf("panel %s %s\n", faults[fault - 1].name, cheapest.c_str());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace grainproof::faults
