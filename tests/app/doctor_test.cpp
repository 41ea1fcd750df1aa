// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/app/program.hpp"

namespace grainproof::testing {
namespace {

TEST(DoctorCommand, ListsDevicesWithTheirPrecisions) {
  const Ended ended = run_program("doctor");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("single"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("liggghts"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("lammps"), std::string::npos) << ended.out;
}

TEST(DoctorCommand, SaysWhatToInstall) {
  const Ended ended =
      run_program("doctor", "OCL_ICD_VENDORS=/nonexistent OPENCL_VENDOR_PATH=/nonexistent PATH=/nonexistent");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("apt-get install pocl-opencl-icd"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("apt-get install liggghts"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("apt-get install lammps"), std::string::npos) << ended.out;
}

TEST(DataFolder, ThatIsNoneIsRefused) {
  const Ended ended = run_program("doctor", "GRAINPROOF_DATA=/nonexistent");
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("/nonexistent"), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace grainproof::testing
