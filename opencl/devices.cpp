// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/devices.hpp"

#include <algorithm>
#include <charconv>

#include "model/errors.hpp"
#include "opencl/engine.hpp"

namespace grainproof::opencl {
namespace {

bool is_gpu(const cl::Device& device) {
  return (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0;
}

std::vector<cl::Device> devices_of(const cl::Platform& platform) {
  std::vector<cl::Device> found;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
  } catch (const cl::Error&) {
    found.clear();  // a platform without a device says so by an error
  }
  return found;
}

DeviceDescription describe(const cl::Device& device) {
  DeviceDescription d;
  d.name = device.getInfo<CL_DEVICE_NAME>();
  d.platform = cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>();
  d.version = device.getInfo<CL_DEVICE_VERSION>() + ", driver " + device.getInfo<CL_DRIVER_VERSION>();
  d.gpu = is_gpu(device);
  d.double_precision = has_double(device);
  if (!d.double_precision) d.no_double_because = "the device has no cl_khr_fp64";
  return d;
}

std::string names_of(const std::vector<cl::Device>& devices) {
  std::string names;
  for (std::size_t i = 0; i < devices.size(); ++i)
    names += (i == 0 ? "" : ", ") + std::to_string(i) + ": " + devices[i].getInfo<CL_DEVICE_NAME>();
  return names;
}

}  // namespace

std::vector<cl::Device> all_devices() {
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {
    return {};  // the loader reports the absence of any platform as an error
  }
  std::vector<cl::Device> devices;
  for (const cl::Platform& platform : platforms) {
    const auto found = devices_of(platform);
    devices.insert(devices.end(), found.begin(), found.end());
  }
  return devices;
}

bool has_double(const cl::Device& device) {
  return device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") != std::string::npos;
}

std::vector<DeviceDescription> list_devices() {
  std::vector<DeviceDescription> list;
  for (const cl::Device& device : all_devices()) list.push_back(describe(device));
  return list;
}

cl::Device choose_device(const std::string& choice) {
  const std::vector<cl::Device> devices = all_devices();
  if (devices.empty())
    throw EngineFailed("no OpenCL device found; on Debian install pocl-opencl-icd to run on the processor");
  if (choice.empty()) {
    const auto gpu = std::find_if(devices.begin(), devices.end(), is_gpu);
    return gpu != devices.end() ? *gpu : devices.front();
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), index);
  if (error == std::errc{} && end == choice.data() + choice.size() && index < devices.size())
    return devices[index];
  const auto named = std::find_if(devices.begin(), devices.end(), [&](const cl::Device& d) {
    return d.getInfo<CL_DEVICE_NAME>().find(choice) != std::string::npos;
  });
  if (named == devices.end())
    throw EngineFailed("no OpenCL device '" + choice + "'; there is " + names_of(devices));
  return *named;
}

}  // namespace grainproof::opencl
