// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/workshop.hpp"

#include <array>

#include "opencl/devices.hpp"
#include "opencl/layout.hpp"
#include "opencl/sources.hpp"

namespace grainproof::opencl {
namespace {

/// With its last context PoCL forgets its library of built-in functions, and the next program waits 0.7 s
/// until it has been read again: half of what a small one takes to build. So the first context stays for
/// good.
void keep_compiler(const cl::Context& context) {
  static const auto* kept = new cl::Context(context);
  (void)kept;
}

}  // namespace

cl::Kernel& Program::kernel(const std::string& name) {
  auto found = kernels_.find(name);
  if (found == kernels_.end())
    found = kernels_.emplace(name, guarded(device_, name, [&] { return cl::Kernel(built_, name.c_str()); }))
                .first;
  return found->second;
}

Workshop::Workshop(const std::string& device_choice, std::filesystem::path kernels)
    : kernels_folder_(std::move(kernels)) {
  guarded("device '" + device_choice + "'", "", [&] {
    device_ = choose_device(device_choice);
    name_ = device_.getInfo<CL_DEVICE_NAME>();
    version_ = device_.getInfo<CL_DEVICE_VERSION>() + ", driver " + device_.getInfo<CL_DRIVER_VERSION>();
    has_double_ = has_double(device_);
    gpu_ = (device_.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0;
    pocl_ = device_.getInfo<CL_DEVICE_VERSION>().find("PoCL") != std::string::npos ||
            device_.getInfo<CL_DEVICE_VERSION>().find("pocl") != std::string::npos;
    correctly_rounded_ =
        (device_.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
    compute_units_ = device_.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    largest_group_ = device_.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    largest_buffer_ = device_.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    context_ = cl::Context(device_);
    if (pocl_) keep_compiler(context_);
    queue_ = cl::CommandQueue(context_, device_);
  });
}

cl::Buffer Workshop::upload(const Bytes& bytes) {
  return guarded(name_, "", [&] {
    // Copied at once; OpenCL's signature is not const-correct.
    return cl::Buffer(context_, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR, bytes.size(),
                      const_cast<std::byte*>(bytes.data()));
  });
}

cl::Buffer Workshop::room(std::size_t bytes) {
  return guarded(name_, "", [&] { return cl::Buffer(context_, CL_MEM_READ_WRITE, bytes); });
}

cl::Buffer Workshop::part(cl::Buffer& whole, std::size_t offset, std::size_t bytes) {
  return guarded(name_, "", [&] {
    const cl_buffer_region region{offset, bytes};
    return whole.createSubBuffer(CL_MEM_READ_WRITE, CL_BUFFER_CREATE_TYPE_REGION, &region);
  });
}

void Workshop::write(cl::Buffer& buffer, std::span<const std::byte> bytes) {
  guarded(name_, "", [&] { queue_.enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes.size(), bytes.data()); });
}

void Workshop::read(const cl::Buffer& buffer, std::span<std::byte> into, std::size_t offset) {
  guarded(name_, "", [&] { queue_.enqueueReadBuffer(buffer, CL_TRUE, offset, into.size(), into.data()); });
}

void Workshop::read_later(const cl::Buffer& buffer, std::span<std::byte> into) {
  guarded(name_, "", [&] { queue_.enqueueReadBuffer(buffer, CL_FALSE, 0, into.size(), into.data()); });
}

void Workshop::finish() {
  guarded(name_, "", [&] { queue_.finish(); });
}

Program& Workshop::program(const BuildOptions& options) {
  return program(kernel_files(options, pocl_), definitions(options), options.precision);
}

Program& Workshop::program(const DenseOptions& options) {
  return program(dense_kernel_files(options, pocl_), dense_definitions(options), options.precision);
}

Program& Workshop::program(const std::vector<std::string>& files, const std::string& defined,
                           Precision precision) {
  std::string flags = "-cl-std=CL1.2" + defined;
  if (correctly_rounded_) flags += " -cl-fp32-correctly-rounded-divide-sqrt";
  std::string key = flags;
  for (const std::string& file : files) key += ' ' + file;
  auto found = programs_.find(key);
  if (found == programs_.end()) {
    auto made = std::make_unique<Program>(build(files, flags), name_);
    compare_sizes(*made, precision);
    found = programs_.emplace(key, std::move(made)).first;
  }
  return *found->second;
}

cl::Program Workshop::build(const std::vector<std::string>& files, const std::string& flags) const {
  const std::string source = assembled_source(kernels_folder_, files);
  return guarded(name_, "", [&] {
    cl::Program program(context_, source);
    program.build({device_}, flags.c_str());
    return program;
  });
}

void Workshop::compare_sizes(Program& program, Precision precision) {
  const auto expected = shared_sizes(precision);
  std::array<cl_int, expected.size()> found{};
  const cl::Buffer buffer = room(sizeof(found));
  launch(program, "sizes", {1, 1}, buffer);
  read(buffer, std::as_writable_bytes(std::span(found)));
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (found[i] != expected[i])
      throw EngineFailed("type " + std::to_string(i) + " of kernels/sizes.cl has " +
                         std::to_string(found[i]) + " bytes on " + name_ + ", expected " +
                         std::to_string(expected[i]));
}

void Workshop::check_argument_count(const cl::Kernel& kernel, const std::string& name,
                                    std::size_t given) const {
  const std::size_t wanted = guarded(name_, name, [&] { return kernel.getInfo<CL_KERNEL_NUM_ARGS>(); });
  if (wanted != given)
    throw DeviceError(
        "launch with " + std::to_string(given) + " arguments instead of " + std::to_string(wanted),
        CL_INVALID_KERNEL_ARGS, name_, name);
}

}  // namespace grainproof::opencl
