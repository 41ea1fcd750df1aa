// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>

#include "model/errors.hpp"
#include "opencl/cl.hpp"

namespace grainproof::opencl {

/// An OpenCL call failed. `what()` has all of it in words.
class DeviceError : public EngineFailed {
 public:
  DeviceError(std::string failed_call, cl_int failed_code, std::string on_device, std::string in_kernel = "",
              std::string log = "")
      : EngineFailed("OpenCL: " + failed_call + " failed with " + std::to_string(failed_code) + " on " +
                     on_device + (in_kernel.empty() ? "" : ", kernel " + in_kernel) +
                     (log.empty() ? "" : ":\n" + log)),
        call(std::move(failed_call)),
        code(failed_code),
        device(std::move(on_device)),
        kernel(std::move(in_kernel)),
        build_log(std::move(log)) {}

  std::string call;
  cl_int code;
  std::string device;
  std::string kernel;
  std::string build_log;
};

/// Does `work`, turning the bindings' exception into ours.
template <class Work>
decltype(auto) guarded(const std::string& device, const std::string& kernel, Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (const cl::BuildError& e) {
    std::string log;
    for (const auto& [built_for, text] : e.getBuildLog()) log += text;
    throw DeviceError(e.what(), e.err(), device, kernel, log);
  } catch (const cl::Error& e) {
    throw DeviceError(e.what(), e.err(), device, kernel);
  }
}

}  // namespace grainproof::opencl
