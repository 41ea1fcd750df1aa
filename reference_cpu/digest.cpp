// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "reference_cpu/digest.hpp"

#include <bit>

namespace grainproof::reference {
namespace {

/// A multiplicative hash with the finaliser of splitmix64 after each word.
class Hash {
 public:
  void add(std::uint64_t word) {
    std::uint64_t z = (value_ ^ word) + 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    value_ = z ^ (z >> 31);
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Vec3& vector) {
    for (const double component : vector) add(component);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace

std::uint64_t digest_of(const State& state) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(state.step));
  hash.add(state.velocity_lag);
  for (const std::int64_t id : state.ids) hash.add(static_cast<std::uint64_t>(id));
  for (const Vec3& position : state.position) hash.add(position);
  for (const Vec3& velocity : state.velocity) hash.add(velocity);
  for (const Vec3& angular_velocity : state.angular_velocity) hash.add(angular_velocity);
  for (const Quaternion& orientation : state.orientation)
    for (const double component : orientation.coeffs()) hash.add(component);
  for (const ContactMemory& memory : state.contacts) {
    hash.add(static_cast<std::uint64_t>(memory.first));
    hash.add(static_cast<std::uint64_t>(memory.second));
    hash.add(static_cast<std::uint64_t>(memory.feature));
    hash.add(memory.tangential_displacement);
    hash.add(memory.overlap);
    hash.add(memory.rolling_torque);
  }
  return hash.value();
}

}  // namespace grainproof::reference
