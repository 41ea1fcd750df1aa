// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "input/node.hpp"
#include "input/text.hpp"

namespace grainproof::input {

Table root(const Document& document) {
  return {document, document.tree, ""};
}

Table::Table(const Document& document, const toml::table& table, std::string_view name)
    : document_(&document), table_(&table), name_(name) {}

const Table& Table::only(std::initializer_list<std::string_view> known) const {
  for (const auto& [key, value] : *table_) {
    if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    const std::string where = name_.empty() ? "" : " in " + std::string(name_);
    refuse_at(document_->name, key.source().begin, "unknown key " + in_quotes(key.str()) + where,
              meant(key.str(), {known.begin(), known.end()}));
  }
  return *this;
}

bool Table::has(std::string_view key) const {
  return table_->contains(key);
}

std::optional<Node> Table::find(std::string_view key) const {
  const auto found = table_->find(key);
  if (found == table_->end()) return std::nullopt;
  return Node(*document_, found->second, found->first.str());
}

Node Table::at(std::string_view key) const {
  const auto found = find(key);
  if (!found)
    whole().refuse("no " + in_quotes(key) + (name_.empty() ? "" : " in " + std::string(name_)),
                   in_quotes(key) + ", which has no default");
  return *found;
}

std::vector<Node> Table::nodes() const {
  std::vector<Node> out;
  for (const auto& [key, value] : *table_) out.emplace_back(*document_, value, key.str());
  return out;
}

Node Table::whole() const {
  return {*document_, *table_, name_};
}

bool Table::boolean(std::string_view key, bool otherwise) const {
  const auto found = find(key);
  return found ? found->boolean() : otherwise;
}

}  // namespace grainproof::input
