// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Mistakes planted in the reference and in the closed forms, one at a time. Each must be judged wrong by the
// case that is named with it, and without any of them that case must hold.
#include <gtest/gtest.h>

#include <array>
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

/// Particles times steps of all that a case sweeps over: what it costs, the same on every machine.
double work_of(const Case& subject) {
  double work = 0.0;
  for (const ResolvedScene& one : subject.scenes)
    work += static_cast<double>(one.scene.particles.size()) * one.scene.run.end / one.scene.run.step;
  return work;
}

/// The cases that no engine but the reference is needed for, the cheapest first.
std::multimap<double, std::string> cases_by_work() {
  std::multimap<double, std::string> cases;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const Case subject = read_case(entry.path(), {});
    if (subject.tier == Tier::quick) cases.emplace(work_of(subject), entry.path().stem());
  }
  return cases;
}

/// The cheapest case that catches a fault. Those cheaper than the one that is known to are asked; where that
/// one is of both engines, it alone is.
std::string cheapest_case(int number, const std::multimap<double, std::string>& cases) {
  const HostFault& fault = faults[number - 1];
  const double known = work_of(read_case(case_file(fault.scene), {}));
  reference::ReferenceEngine engine;
  for (const auto& [work, name] : cases) {
    if (work >= known || fault.opencl) break;
    if (!failed(rows_of(number, name, engine)).empty()) return name;
  }
  return fault.scene;
}

/// An answer more than a test, for tests/faults/score.py.
TEST(Panel, DISABLED_CheapestCaseOfEachFault) {
  const auto cases = cases_by_work();
  for (int fault = 1; fault <= static_cast<int>(std::size(faults)); ++fault) {
    std::printf("panel %s %s\n", faults[fault - 1].name, cheapest_case(fault, cases).c_str());
    std::fflush(stdout);
  }
}

TEST(Panel, FindsACaseThatCatchesAndCostsNoMore) {
  const auto cases = cases_by_work();
  reference::ReferenceEngine engine;
  for (int fault = 1; fault <= 3; ++fault) {
    const std::string cheapest = cheapest_case(fault, cases);
    EXPECT_FALSE(failed(rows_of(fault, cheapest, engine)).empty()) << cheapest;
    EXPECT_LE(work_of(read_case(case_file(cheapest), {})),
              work_of(read_case(case_file(faults[fault - 1].scene), {})));
  }
}

}  // namespace
}  // namespace grainproof::faults
