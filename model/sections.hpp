// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "model/errors.hpp"

namespace grainproof {

/// Named bytes that mean something to whoever packed them, and to nobody else.
using Sections = std::map<std::string, std::vector<std::byte>>;

/// A section's name tells the size of its values too, so that those of another layout are not found.
template <class Value>
std::string sized(const std::string& name) {
  return name + ":" + std::to_string(sizeof(Value));
}

/// Values as they lie in memory: plain numbers, and structures of such that hold no pointers.
template <class Value>
void pack(Sections& sections, const std::string& name, const std::vector<Value>& values) {
  static_assert(std::is_trivially_destructible_v<Value>, "what owns memory cannot be packed as it lies");
  const auto* begin = reinterpret_cast<const std::byte*>(values.data());
  sections[sized<Value>(name)].assign(begin, begin + values.size() * sizeof(Value));
}

/// Throws InputRefused where the section is missing or does not hold whole values.
template <class Value>
void unpack(const Sections& sections, const std::string& name, std::vector<Value>& values) {
  static_assert(std::is_trivially_destructible_v<Value>, "what owns memory cannot be packed as it lies");
  const auto found = sections.find(sized<Value>(name));
  if (found == sections.end()) throw InputRefused("the checkpoint lacks its part '" + name + "'");
  if (found->second.size() % sizeof(Value) != 0)
    throw InputRefused("the part '" + name + "' of the checkpoint does not hold whole values");
  values.resize(found->second.size() / sizeof(Value));
  if (!values.empty())
    std::memcpy(static_cast<void*>(values.data()), found->second.data(), found->second.size());
}

template <class Value>
void pack_one(Sections& sections, const std::string& name, const Value& value) {
  pack(sections, name, std::vector<Value>{value});
}

template <class Value>
void unpack_one(const Sections& sections, const std::string& name, Value& value) {
  std::vector<Value> values;
  unpack(sections, name, values);
  if (values.size() != 1)
    throw InputRefused("the part '" + name + "' of the checkpoint does not hold one value");
  value = values.front();
}

}  // namespace grainproof
