// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "opencl/cl.hpp"

namespace grainproof::opencl {

/// Every device of every platform, in the order of list_devices().
std::vector<cl::Device> all_devices();

/// By index, by part of its name, or by `choice` empty the first GPU, else the first device.
/// Throws EngineFailed naming what there is.
cl::Device choose_device(const std::string& choice);

bool has_double(const cl::Device& device);

}  // namespace grainproof::opencl
