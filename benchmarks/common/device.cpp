// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/device.hpp"

#include <chrono>

#include "opencl/device_error.hpp"
#include "opencl/devices.hpp"
#include "opencl/sources.hpp"

namespace grainproof::bench {

Device::Device(const Settings& settings, const std::string& sources, const std::string& options)
    : device_(opencl::choose_device(settings.device)), context_(device_), queue_(context_, device_) {
  const std::string name = device_.getInfo<CL_DEVICE_NAME>();
  opencl::guarded(name, sources, [&] {
    program_ = cl::Program(context_, opencl::assembled_source(settings.data / "benchmarks", {sources}));
    program_.build({device_}, options.c_str());
  });
}

cl::Buffer Device::room(std::size_t bytes) {
  return {context_, CL_MEM_READ_WRITE, bytes};
}

cl::Kernel Device::kernel(const std::string& name) {
  return {program_, name.c_str()};
}

double Device::seconds(const cl::Kernel& kernel, std::size_t items, std::size_t group, int times) {
  const auto launch = [&] {
    queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(items), cl::NDRange(group));
  };
  launch();
  queue_.finish();
  const auto began = std::chrono::steady_clock::now();
  for (int n = 0; n < times; ++n) launch();
  queue_.finish();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

}  // namespace grainproof::bench
