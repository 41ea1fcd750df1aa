// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "tests/fuzz/odd_pieces.hpp"

namespace grainproof::fuzz {
namespace {

constexpr std::string_view digits = "0123456789";

/// Begin and end of a number at or after `from`; equal where there is none.
std::pair<std::size_t, std::size_t> number_in(const std::string& text, std::size_t from) {
  std::size_t begin = text.find_first_of(digits, from);
  if (begin == std::string::npos) return {0, 0};
  std::size_t end = text.find_first_not_of("0123456789.eE+-_", begin);
  if (end == std::string::npos) end = text.size();
  if (begin > 0 && text[begin - 1] == '-') --begin;
  return {begin, end};
}

/// Places behind every occurrence of `mark`.
std::vector<std::size_t> places(const std::string& text, std::string_view mark) {
  std::vector<std::size_t> all;
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1))
    all.push_back(at);
  return all;
}

std::vector<std::string> split(const std::string& text, std::string_view mark) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (const std::size_t at : places(text, mark)) {
    parts.push_back(text.substr(begin, at + mark.size() - begin));
    begin = at + mark.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string all;
  for (const std::string& part : parts) all += part;
  return all;
}

/// Of the lines that begin so.
std::vector<std::size_t> numbers_of(const std::vector<std::string>& lines, std::string_view beginning) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].starts_with(beginning)) numbers.push_back(i);
  return numbers;
}

/// Names and texts, without repetition and in an order of their own.
std::vector<std::string> words_of(const std::vector<std::string>& texts) {
  std::set<std::string> words;
  for (const std::string& text : texts)
    for (std::size_t at = 0; at < text.size();) {
      const auto is_word = [&](std::size_t i) {
        return i < text.size() && (std::isalpha(text[i]) || text[i] == '_');
      };
      if (!is_word(at)) {
        ++at;
        continue;
      }
      std::size_t end = at;
      while (is_word(end)) ++end;
      words.insert(text.substr(at, end - at));
      at = end;
    }
  return {words.begin(), words.end()};
}

std::string without_comments(const std::string& text) {
  std::string code;
  for (const std::string& line : split(text, "\n"))
    if (!line.starts_with('#')) code += line;
  return code;
}

}  // namespace

Mutator::Mutator(std::vector<std::string> seeds, std::uint64_t seed) : random_(seed) {
  for (const std::string& text : seeds) seeds_.push_back(without_comments(text));
  words_ = words_of(seeds_);
  std::set<std::string> lines, tables, values;
  for (const std::string& text : seeds_) {
    for (std::string& table : split(text, "\n\n")) tables.insert(std::move(table));
    for (std::string& line : split(text, "\n")) {
      if (const std::size_t at = line.find(" = "); at != std::string::npos)
        values.insert(line.substr(at + 3, line.size() - at - 4));
      lines.insert(std::move(line));
    }
  }
  lines_.assign(lines.begin(), lines.end());
  tables_.assign(tables.begin(), tables.end());
  values_.assign(values.begin(), values.end());
}

std::string Mutator::next() {
  std::string text = one_of(seeds_);
  const std::size_t changes =
      below(3) == 0 ? 2 + below(4) : 1;  // most files with several are refused for the first
  for (std::size_t n = 0; n < changes; ++n) text = mutated(text);
  return text;
}

std::string Mutator::mutated(const std::string& text) {
  switch (below(19)) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
    case 5:
      return with_another_number(text);
    case 6:
    case 7:
      return with_another_value(text);
    case 8:
    case 9:
    case 10:
      return with_another_word(text);
    case 11:
    case 12:
      return with_lines_changed(text);
    case 13:
    case 14:
      return with_tables_changed(text);
    case 15:
    case 16:
      return with_a_key_added(text);
    case 17:
      return with_a_comment(text);
    default:
      return with_bytes_changed(text);
  }
}

std::string Mutator::number(const std::string& old) {
  switch (below(6)) {
    case 0:
      return "-" + old;
    case 1:
      return old + "e" + std::to_string(static_cast<int>(below(40)) - 20);
    case 2:
      return std::to_string(static_cast<int>(below(200)) - 100);
    case 3:
      return std::to_string(static_cast<double>(below(2000)) / 1000.0 - 1.0);
    default:
      return std::string(one_of(edges));
  }
}

std::string Mutator::with_another_number(const std::string& text) {
  const auto [begin, end] = number_in(text, below(text.size()));
  if (begin == end) return text;
  return text.substr(0, begin) + number(text.substr(begin, end - begin)) + text.substr(end);
}

std::string Mutator::value() {
  return below(3) == 0 ? std::string(one_of(odd_values)) : one_of(values_);
}

std::string Mutator::with_another_value(const std::string& text) {
  const auto at = places(text, " = ");
  if (at.empty()) return text;
  const std::size_t begin = one_of(at) + 3;
  const std::size_t end = text.find_first_of(below(2) == 0 ? "\n" : ",}\n", begin);
  return text.substr(0, begin) + value() + (end == std::string::npos ? "" : text.substr(end));
}

std::string Mutator::with_another_word(const std::string& text) {
  const std::size_t from = below(text.size());
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; };
  const auto begin = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(from), text.end(), letter);
  const auto end = std::find_if_not(begin, text.end(), letter);
  return std::string(text.begin(), begin) + one_of(words_) + std::string(end, text.end());
}

std::string Mutator::with_lines_changed(const std::string& text) {
  std::vector<std::string> lines = split(text, "\n");
  const auto at = lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size()));
  switch (below(4)) {
    case 0:
      lines.erase(at);
      break;
    case 1:
      lines.insert(at, one_of(lines_));
      break;
    case 2:
      lines.insert(at, std::string(*at));
      break;
    default:
      std::swap(*at, lines[below(lines.size())]);
  }
  return joined(lines);
}

std::string Mutator::with_tables_changed(const std::string& text) {
  std::vector<std::string> tables = split(text, "\n\n");
  const auto at = tables.begin() + static_cast<std::ptrdiff_t>(below(tables.size()));
  switch (below(3)) {
    case 0:
      tables.erase(at);
      break;
    case 1:
      tables.insert(at, one_of(tables_));
      break;
    default:
      tables.insert(at, std::string(*at));
  }
  return joined(tables);
}

/// Mostly into the table that it belongs to, in place of what is said of it there.
std::string Mutator::with_a_key_added(const std::string& text) {
  const auto& [table, line] = one_of(rare_keys);
  std::vector<std::string> lines = split(text, "\n");
  const auto headers = numbers_of(lines, below(4) == 0 ? "[" : table);
  if (headers.empty()) return text + "\n" + std::string(table) + "\n" + std::string(line) + "\n";
  const std::size_t header = one_of(headers);
  const std::string_view key = line.substr(0, line.find('=') + 1);
  for (std::size_t i = header + 1; i < lines.size() && !lines[i].starts_with('['); ++i)
    if (lines[i].starts_with(key)) lines[i].clear();
  lines[header] += std::string(line) + "\n";
  return joined(lines);
}

/// Where a line ends or begins, between the elements of an array, or anywhere at all.
std::string Mutator::with_a_comment(const std::string& text) {
  constexpr std::string_view behind[] = {"\n", ",", "[", "", "\"", "="};
  const std::string_view mark = one_of(behind);
  const auto at = places(text, mark);
  if (at.empty()) return text;
  std::string changed = text;
  return changed.insert(one_of(at) + below(2) * mark.size(), one_of(comments));
}

std::string Mutator::with_bytes_changed(const std::string& text) {
  std::string changed = text;
  const std::size_t at = below(text.size() + 1);
  switch (below(5)) {
    case 0:
      return text.substr(0, at);
    case 1:
      if (at < changed.size()) changed[at] ^= static_cast<char>(1u << below(8));
      return changed;
    case 2:
      return changed.insert(at, std::string(1 + below(400), "[{(\"a.9"[below(7)]));
    case 3:
      return changed.erase(at, 1 + below(20));
    default:
      return changed.insert(at, one_of(rubbish));
  }
}

}  // namespace grainproof::fuzz
