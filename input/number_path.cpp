// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <charconv>

#include "input/sweep.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

const std::vector<std::string_view> sweep_keys{"step",        "step_dither", "onset", "integrator",
                                               "orientation", "offset",      "scale", "seeds"};

const toml::node* element(const toml::array& array, std::string_view part) {
  std::size_t index = 0;
  const auto read = std::from_chars(part.data(), part.data() + part.size(), index);
  if (read.ec != std::errc{} || read.ptr != part.data() + part.size()) return nullptr;
  return array.get(index);
}

const toml::node* child(const toml::node& node, std::string_view part) {
  if (const auto* table = node.as_table()) return table->get(part);
  if (const auto* array = node.as_array()) return element(*array, part);
  return nullptr;
}

const toml::node* follow(const toml::table& tree, std::string_view path) {
  const toml::node* node = &tree;
  while (node != nullptr) {
    const std::size_t dot = path.find('.');
    node = child(*node, path.substr(0, dot));
    if (dot == std::string_view::npos) break;
    path.remove_prefix(dot + 1);
  }
  return node;
}

/// Only what describes the scene may vary; the run's step has a key of its own.
bool may_vary(std::string_view path) {
  for (const std::string_view table :
       {"run.", "domain.", "material.", "contact.", "particles.", "wall.", "field."})
    if (path.starts_with(table)) return path != "run.step";
  return false;
}

}  // namespace

const toml::node& number_at(const Document& document, const Node& key) {
  const toml::node* node = may_vary(key.name()) ? follow(document.tree, key.name()) : nullptr;
  if (node != nullptr && node->is_number()) return *node;
  key.refuse(
      "sweep key " + in_quotes(key.name()) + " that leads to no number of the scene",
      meant(key.name(), sweep_keys) + ", or the path of a number such as \"contact.0.normal.restitution\"");
}

}  // namespace grainproof::input
