// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstring>
#include <span>
#include <vector>

#include "opencl/layout.hpp"
#include "opencl/scene_image.hpp"

namespace grainproof::opencl {

/// A buffer is never empty: OpenCL has none of size zero.
template <class T>
Bytes bytes_of(const std::vector<T>& values) {
  Bytes bytes(sizeof(T) * std::max<std::size_t>(values.size(), 1));
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), sizeof(T) * values.size());
  return bytes;
}

template <class T>
T value_at(std::span<const std::byte> bytes, std::size_t i) {
  T value;
  std::memcpy(&value, bytes.data() + i * sizeof(T), sizeof(T));
  return value;
}

template <class P>
typename P::Real4 four_of(const Vec3& v, double w = 0.0) {
  using Real = typename P::Real;
  return {{static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2]), static_cast<Real>(w)}};
}

}  // namespace grainproof::opencl
