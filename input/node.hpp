// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/vec3.hpp"

/// A typed view of the TOML tree that knows where it is, so that everything refused names its place.
namespace grainproof::input {

/// A parsed file. `replaced` holds the values that a point of the sweep puts in place of written ones.
struct Document {
  std::string name;
  toml::table tree;
  std::map<const toml::node*, const toml::node*> replaced;
  std::int64_t seed_shift = 0;  ///< added to every seed of the scene: the sample of a sweep over seeds
};

/// Whole numbers that a double, and so JSON, holds exactly.
constexpr std::int64_t largest_seed = std::int64_t{1} << 53;

/// Throws InputRefused where the text is not TOML.
Document parse(const std::string& text, const std::string& name);

class Table;

/// One value of the file. All reading functions throw InputRefused when the value isn't what they read.
class Node {
 public:
  Node(const Document& document, const toml::node& node, std::string_view name);

  std::string_view name() const { return name_; }
  const toml::node& raw() const { return *node_; }
  bool is_table() const { return node_->is_table(); }
  bool is_array() const { return node_->is_array(); }
  bool is_text() const { return node_->is_string(); }
  bool is_number() const { return node_->is_number(); }

  bool boolean() const;
  double number() const;  ///< finite
  double positive() const;
  double not_negative() const;
  double number_within(double least, double most) const;
  std::int64_t integer_within(std::int64_t least, std::int64_t most) const;
  std::int64_t seed() const;  ///< of a scene's random numbers
  std::string text() const;
  Vec3 vector() const;
  Table table() const;
  std::vector<Node> elements() const;  ///< of an array
  std::vector<Node> at_least_one() const;
  std::vector<Node> tables() const;  ///< of an array of tables

  /// One of the names; `what` says what they are.
  template <class T, std::size_t N>
  T choice(const std::pair<std::string_view, T> (&names)[N]) const {
    const std::string wanted = text();
    std::vector<std::string_view> known;
    for (const auto& [known_name, value] : names) {
      if (known_name == wanted) return value;
      known.push_back(known_name);
    }
    refuse_name(known);
  }

  std::string described() const;  ///< the value in words, for messages
  std::string label() const;      ///< the value as a label: 0.8, velocity_verlet, [1, 0, 0]

  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const;
  [[noreturn]] void refuse(const std::string& expected) const;
  [[noreturn]] void refuse_name(const std::vector<std::string_view>& known) const;

 private:
  const Document* document_;
  const toml::node* node_;
  std::string_view name_;
};

/// A table of the file.
class Table {
 public:
  Table(const Document& document, const toml::table& table, std::string_view name);

  /// Refuses every key but these.
  const Table& only(std::initializer_list<std::string_view> known) const;

  bool has(std::string_view key) const;
  Node at(std::string_view key) const;  ///< refuses the table where the key is missing
  std::optional<Node> find(std::string_view key) const;
  std::vector<Node> nodes() const;  ///< all values, by name
  Node whole() const;

  bool boolean(std::string_view key, bool otherwise) const;

 private:
  const Document* document_;
  const toml::table* table_;
  std::string_view name_;
};

Table root(const Document& document);

[[noreturn]] void refuse_at(const std::string& file, const toml::source_position& place,
                            const std::string& found, const std::string& expected);

}  // namespace grainproof::input
