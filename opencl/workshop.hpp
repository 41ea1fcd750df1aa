// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

#include "opencl/build_options.hpp"
#include "opencl/dense_options.hpp"
#include "opencl/device_error.hpp"
#include "opencl/scene_image.hpp"

namespace grainproof::opencl {

/// A built program and its kernels by name.
class Program {
 public:
  Program(cl::Program built, std::string device) : built_(std::move(built)), device_(std::move(device)) {}

  cl::Kernel& kernel(const std::string& name);

 private:
  cl::Program built_;
  std::string device_;
  std::map<std::string, cl::Kernel> kernels_;
};

/// How many work-items, in groups of how many. The group is always said: a device left to choose
/// may compile a kernel anew for every size.
struct Range {
  std::size_t items;
  std::size_t group;
};

/// A device, its in-order queue and the programs built for it. Every OpenCL call goes through here and
/// fails as DeviceError.
class Workshop {
 public:
  Workshop(const std::string& device_choice, std::filesystem::path kernels);

  const std::string& device_name() const { return name_; }
  const std::string& version() const { return version_; }
  bool has_double_precision() const { return has_double_; }
  bool is_gpu() const { return gpu_; }
  std::size_t largest_group() const { return largest_group_; }
  std::size_t compute_units() const { return compute_units_; }
  std::size_t largest_buffer() const { return largest_buffer_; }

  cl::Buffer upload(const Bytes& bytes);
  cl::Buffer room(std::size_t bytes);
  /// A stretch of a buffer, as a buffer of its own; `offset` is a multiple of 512.
  cl::Buffer part(cl::Buffer& whole, std::size_t offset, std::size_t bytes);
  void write(cl::Buffer& buffer, std::span<const std::byte> bytes);
  void read(const cl::Buffer& buffer, std::span<std::byte> into, std::size_t offset = 0);
  /// Returns at once; `into` is filled by the next read() or finish().
  void read_later(const cl::Buffer& buffer, std::span<std::byte> into);
  void finish();

  /// Builds at most once a process for the same options.
  Program& program(const BuildOptions& options);
  Program& program(const DenseOptions& options);

  /// Enqueues `name` with all of its arguments, in order: buffers and scalars of OpenCL types only.
  template <class... Arguments>
  void launch(Program& program, const std::string& name, Range range, const Arguments&... arguments) {
    static_assert(((std::is_same_v<Arguments, cl::Buffer> || std::is_same_v<Arguments, cl_int> ||
                    std::is_same_v<Arguments, cl::LocalSpaceArg>)&&...),
                  "a kernel takes buffers, cl_int and local memory");
    cl::Kernel& kernel = program.kernel(name);
    check_argument_count(kernel, name, sizeof...(Arguments));
    guarded(name_, name, [&] {
      cl_uint index = 0;
      (kernel.setArg(index++, arguments), ...);
      queue_.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(range.items), cl::NDRange(range.group));
    });
  }

 private:
  void check_argument_count(const cl::Kernel& kernel, const std::string& name, std::size_t given) const;
  Program& program(const std::vector<std::string>& files, const std::string& defined, Precision precision);
  cl::Program build(const std::vector<std::string>& files, const std::string& flags) const;
  void compare_sizes(Program& program, Precision precision);

  std::filesystem::path kernels_folder_;
  cl::Device device_;
  std::string name_;
  std::string version_;
  bool has_double_ = false;
  bool pocl_ = false;
  bool gpu_ = false;
  bool correctly_rounded_ = false;
  std::size_t largest_group_ = 1;
  std::size_t compute_units_ = 1;
  std::size_t largest_buffer_ = 0;
  cl::Context context_;
  cl::CommandQueue queue_;
  std::map<std::string, std::unique_ptr<Program>> programs_;
};

}  // namespace grainproof::opencl
