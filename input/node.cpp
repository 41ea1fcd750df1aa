// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/node.hpp"

#include <algorithm>
#include <cmath>

#include "input/text.hpp"
#include "model/errors.hpp"

namespace grainproof::input {
namespace {

const toml::node& as_swept(const Document& document, const toml::node& node) {
  const auto found = document.replaced.find(&node);
  return found == document.replaced.end() ? node : *found->second;
}

std::string described_value(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* number = node.as_floating_point()) return shortest(number->get());
  if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
  if (const auto* boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
  if (const auto* array = node.as_array()) return "an array of " + std::to_string(array->size());
  return node.is_table() ? "a table" : "a date or time";
}

bool is_plain(char c) {
  return (c >= ' ' && c <= '~') || c == '\t';
}

/// With lines of nothing but a comment left empty, so that places stay what they are: a third of a usual
/// file, which toml++ would decode and look at character by character. Only where the text has no strings of
/// several lines, and the comment no character that TOML may forbid.
std::string without_comment_lines(const std::string& text) {
  if (text.find("\"\"\"") != std::string::npos || text.find("'''") != std::string::npos) return text;
  std::string rest;
  rest.reserve(text.size());
  for (std::size_t begin = 0, end; begin < text.size(); begin = end) {
    end = std::min(text.find('\n', begin), text.size());
    const auto line = std::string_view(text).substr(begin, end - begin);
    if (!line.starts_with('#') || !std::all_of(line.begin(), line.end(), is_plain)) rest += line;
    if (end < text.size()) rest += text[end++];
  }
  return rest;
}

}  // namespace

Document parse(const std::string& text, const std::string& name) {
  try {
    return {name, toml::parse(without_comment_lines(text), std::string_view(name)), {}, 0};
  } catch (const toml::parse_error& error) {
    refuse_at(name, error.source().begin, "a syntax error (" + std::string(error.description()) + ")",
              "TOML 1.0");
  }
}

void refuse_at(const std::string& file, const toml::source_position& place, const std::string& found,
               const std::string& expected) {
  const auto line = std::max<toml::source_index>(place.line, 1);
  const auto column = std::max<toml::source_index>(place.column, 1);
  throw InputRefused(file + ":" + std::to_string(line) + ":" + std::to_string(column) + ": found " + found +
                     "; expected " + expected);
}

Node::Node(const Document& document, const toml::node& node, std::string_view name)
    : document_(&document), node_(&as_swept(document, node)), name_(name) {}

void Node::refuse(const std::string& found, const std::string& expected) const {
  refuse_at(document_->name, node_->source().begin, found, expected);
}

void Node::refuse(const std::string& expected) const {
  refuse(std::string(name_) + " = " + described_value(*node_), expected);
}

void Node::refuse_name(const std::vector<std::string_view>& known) const {
  refuse(meant(text(), known));
}

std::string Node::described() const {
  return described_value(*node_);
}

std::string Node::label() const {
  if (is_number()) return shortest(number());
  if (is_text()) return text();
  std::string out;
  if (is_table()) {
    for (const Node& one : table().nodes())
      out += (out.empty() ? "" : ", ") + std::string(one.name()) + " = " + one.label();
    return "{ " + out + " }";
  }
  if (!is_array()) return described();
  for (const Node& element : elements()) out += (out.empty() ? "" : ", ") + element.label();
  return "[" + out + "]";
}

bool Node::boolean() const {
  const auto* value = node_->as_boolean();
  if (value == nullptr) refuse("true or false");
  return value->get();
}

double Node::number() const {
  if (!is_number()) refuse("a number");
  const double value = node_->value<double>().value_or(std::nan(""));
  if (!std::isfinite(value)) refuse("a finite number");
  return value;
}

double Node::positive() const {
  const double value = number();
  if (!(value > 0.0)) refuse("a number above 0");
  return value;
}

double Node::not_negative() const {
  const double value = number();
  if (!(value >= 0.0)) refuse("0 or a positive number");
  return value;
}

double Node::number_within(double least, double most) const {
  const double value = number();
  if (!(value >= least && value <= most))
    refuse("a number from " + shortest(least) + " to " + shortest(most));
  return value;
}

std::int64_t Node::integer_within(std::int64_t least, std::int64_t most) const {
  const auto* value = node_->as_integer();
  if (value == nullptr || value->get() < least || value->get() > most)
    refuse("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value->get();
}

std::int64_t Node::seed() const {
  return integer_within(0, largest_seed) + document_->seed_shift;
}

std::string Node::text() const {
  const auto* value = node_->as_string();
  if (value == nullptr) refuse("text in quotes");
  return value->get();
}

Vec3 Node::vector() const {
  const auto* array = node_->as_array();
  if (array == nullptr || array->size() != 3) refuse("three numbers, [x, y, z]");
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i)
    out[static_cast<int>(i)] = Node(*document_, *array->get(i), name_).number();
  return out;
}

Table Node::table() const {
  const auto* table = node_->as_table();
  if (table == nullptr) refuse("a table");
  return {*document_, *table, name_};
}

std::vector<Node> Node::elements() const {
  const auto* array = node_->as_array();
  if (array == nullptr) refuse("an array");
  std::vector<Node> out;
  out.reserve(array->size());
  for (const toml::node& element : *array) out.emplace_back(*document_, element, name_);
  return out;
}

std::vector<Node> Node::at_least_one() const {
  std::vector<Node> out = elements();
  if (out.empty()) refuse("at least one element");
  return out;
}

std::vector<Node> Node::tables() const {
  if (is_table()) refuse("a list of tables; write [[" + std::string(name_) + "]]");
  std::vector<Node> out = elements();
  for (const Node& element : out)
    if (!element.is_table()) element.refuse("a table; write [[" + std::string(name_) + "]]");
  return out;
}

}  // namespace grainproof::input
