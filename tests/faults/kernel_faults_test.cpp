// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Mistakes planted in copies of the kernels, one at a time. Each must be judged wrong by the case that is
// named with it.
#include "tests/faults/kernel_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>

#include "opencl/dense_options.hpp"
#include "opencl/engine.hpp"
#include "tests/faults/judged.hpp"

namespace grainproof::faults {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Kernels in a folder of their own, gone with this object.
class KernelCopy {
 public:
  explicit KernelCopy(const std::string& name)
      : folder_(fs::temp_directory_path() / ("grainproof-fault-" + name)) {
    fs::remove_all(folder_);
    fs::copy("kernels", folder_, fs::copy_options::recursive);
  }
  KernelCopy(const KernelCopy&) = delete;
  KernelCopy& operator=(const KernelCopy&) = delete;
  ~KernelCopy() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  const fs::path& folder() const { return folder_; }

  void plant(const KernelFault& fault) const {
    const fs::path file = folder_ / fault.file;
    std::string text = text_of(file);
    const std::size_t at = text.find(fault.printed);
    ASSERT_NE(at, std::string::npos) << fault.printed << " does not stand in " << fault.file;
    ASSERT_EQ(text.find(fault.printed, at + 1), std::string::npos) << fault.printed << " stands twice";
    text.replace(at, std::string(fault.printed).size(), fault.planted);
    std::ofstream(file) << text;
  }

 private:
  fs::path folder_;
};

std::vector<Row> rows_with(const fs::path& kernels, const KernelFault& fault) {
  opencl::EngineOptions options;
  options.precision = fault.precision;
  options.kernels = kernels;
  options.path = fault.path;
  if (fault.skin >= 0.0) options.skin = fault.skin;
  opencl::OpenClEngine engine(options);
  return judged(case_file(fault.scene), engine, fault.samples, [&](const Scene& scene) {
    return fault.path != opencl::Path::dense || opencl::dense_support(scene, {}, 0.0).yes;
  });
}

class KernelFaults : public testing::TestWithParam<KernelFault> {};

TEST_P(KernelFaults, AreNoticed) {
  const KernelCopy copy(GetParam().name);
  ASSERT_NO_FATAL_FAILURE(copy.plant(GetParam()));
  RecordProperty("case", GetParam().scene);
  RecordProperty("of", GetParam().file);
  const auto rows = rows_with(copy.folder(), GetParam());
  EXPECT_FALSE(failed(rows).empty()) << "unnoticed by " << rows.size() << " rows of " << GetParam().scene;
}

// Those that are planted rarely would not be missed for long otherwise.
TEST(EveryKernelFault, HasItsTextExactlyOnceInTheKernels) {
  for (const KernelFault& fault : kernel_faults) {
    const std::string text = text_of(fs::path("kernels") / fault.file);
    const std::size_t at = text.find(fault.printed);
    EXPECT_NE(at, std::string::npos) << fault.name;
    EXPECT_EQ(text.find(fault.printed, at + 1), std::string::npos) << fault.name;
  }
}

bool is_quick(const KernelFault& fault) {
  return std::ranges::find(quick_kernel_faults, std::string_view(fault.name)) !=
         std::end(quick_kernel_faults);
}

std::vector<KernelFault> those(bool quick) {
  std::vector<KernelFault> some;
  for (const KernelFault& fault : kernel_faults)
    if (is_quick(fault) == quick) some.push_back(fault);
  return some;
}

std::string name_of(const testing::TestParamInfo<KernelFault>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(Quick, KernelFaults, testing::ValuesIn(those(true)), name_of);
INSTANTIATE_TEST_SUITE_P(Planted, KernelFaults, testing::ValuesIn(those(false)), name_of);

TEST(FaultsOfEveryDay, AreAllThere) {
  EXPECT_EQ(those(true).size(), std::size(quick_kernel_faults));
}

/// The control: without a fault none of those rows fails. On the path that the engine takes by itself
/// this is what `verify` shows; here are the scenes that it is forced onto another.
class KernelsAsTheyAre : public testing::TestWithParam<KernelFault> {};

TEST_P(KernelsAsTheyAre, PassTheSameCase) {
  for (const Row& row : failed(rows_with("kernels", GetParam())))
    ADD_FAILURE() << row.case_name << ": " << row.quantity << " at " << row.step << ": error " << row.error
                  << ", tolerance " << row.tolerance << " " << row.reason;
}

std::vector<KernelFault> on_a_forced_path() {
  std::vector<KernelFault> forced;
  for (const KernelFault& fault : kernel_faults)
    if (fault.path != opencl::Path::automatic) forced.push_back(fault);
  return forced;
}

INSTANTIATE_TEST_SUITE_P(Control, KernelsAsTheyAre, testing::ValuesIn(on_a_forced_path()), name_of);

}  // namespace
}  // namespace grainproof::faults
