// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>

#include "input/fills.hpp"
#include "input/text.hpp"

namespace grainproof::input {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> out(1);
  for (const char c : line) {
    if (c == ',')
      out.emplace_back();
    else if (c != ' ' && c != '\r' && c != '\t')
      out.back() += c;
  }
  return out;
}

/// A CSV file with a header line, read row by row.
class CsvReader {
 public:
  explicit CsvReader(const std::string& name, std::istream& stream) : name_(name), stream_(stream) {
    std::string line;
    std::getline(stream_, line);
    header_ = split(line);
    for (std::size_t i = 0; i < header_.size(); ++i) check_column(i);
    for (const char* axis : {"x", "y", "z"})
      if (!columns_.contains(axis))
        refuse(0, "no column " + in_quotes(axis), "a header line with x, y and z");
    check_three("vx", "vy", "vz", "a velocity");
    check_three("wx", "wy", "wz", "an angular velocity");
  }

  bool next() {
    std::string line;
    do {
      ++line_;
      if (!std::getline(stream_, line)) return false;
    } while (line.empty() || line == "\r");
    cells_ = split(line);
    if (cells_.size() != header_.size())
      refuse(0, std::to_string(cells_.size()) + " values",
             std::to_string(header_.size()) + ", as in the header");
    return true;
  }

  bool has(const char* column) const { return columns_.contains(column); }

  double number(const char* column) const {
    const std::size_t at = columns_.at(column);
    const std::string& cell = cells_[at];
    double value = 0.0;
    const auto read = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (read.ec != std::errc{} || read.ptr != cell.data() + cell.size() || !std::isfinite(value))
      refuse(at, in_quotes(cell) + " in column " + in_quotes(column), "a finite number");
    return value;
  }

  double diameter() const {
    const double value = number("d");
    if (!(value > 0.0)) refuse(columns_.at("d"), "d " + shortest(value), "a number above 0");
    return value;
  }

  std::int64_t id() const {
    const double value = number("id");
    if (!(value >= 1.0 && value <= static_cast<double>(largest_id) && value == std::floor(value)))
      refuse(columns_.at("id"), "id " + shortest(value), "a whole number from 1");
    return static_cast<std::int64_t>(value);
  }

 private:
  void check_three(const char* x, const char* y, const char* z, const std::string& what) const {
    if (has(x) == has(y) && has(x) == has(z)) return;
    refuse(0, what + " with a component missing",
           std::string(x) + ", " + y + " and " + z + ", or none of them");
  }

  void check_column(std::size_t at) {
    const std::vector<std::string_view> known{"id", "x", "y", "z", "d", "vx", "vy", "vz", "wx", "wy", "wz"};
    if (std::find(known.begin(), known.end(), header_[at]) == known.end())
      refuse(at, "unknown column " + in_quotes(header_[at]), meant(header_[at], known));
    if (!columns_.emplace(header_[at], at).second)
      refuse(at, in_quotes(header_[at]) + " twice", "each column once");
  }

  /// Places are counted in values: the column of a CSV file.
  [[noreturn]] void refuse(std::size_t at, const std::string& found, const std::string& expected) const {
    refuse_at(name_, {static_cast<toml::source_index>(line_), static_cast<toml::source_index>(at + 1)}, found,
              expected);
  }

  std::string name_;
  std::istream& stream_;
  std::vector<std::string> header_;
  std::map<std::string, std::size_t, std::less<>> columns_;
  std::vector<std::string> cells_;
  std::size_t line_ = 1;
};

}  // namespace

std::vector<Filled> fill_from_file(const Table& table, const std::filesystem::path& folder,
                                   std::size_t largest) {
  table.only({"kind", "path"});
  const Node path_node = table.at("path");
  const std::filesystem::path path = folder / path_node.text();
  std::error_code ignored;
  std::ifstream stream(path);
  if (!std::filesystem::is_regular_file(path, ignored) || !stream)
    path_node.refuse("path = " + in_quotes(path.string()), "a file that can be read");
  CsvReader csv(path.string(), stream);
  const bool moving = csv.has("vx");
  std::vector<Filled> filled;
  while (csv.next()) {
    if (filled.size() == largest)
      path_node.refuse("more than " + std::to_string(largest) + " particles", "fewer");
    Filled particle{{csv.number("x"), csv.number("y"), csv.number("z")}, {}, {}};
    if (moving) particle.velocity = Vec3(csv.number("vx"), csv.number("vy"), csv.number("vz"));
    if (csv.has("wx")) particle.angular_velocity = Vec3(csv.number("wx"), csv.number("wy"), csv.number("wz"));
    if (csv.has("d")) particle.diameter = csv.diameter();
    if (csv.has("id")) particle.id = csv.id();
    filled.push_back(particle);
  }
  if (filled.empty())
    path_node.refuse(in_quotes(path.string()) + " without particles", "at least one line of values");
  return filled;
}

}  // namespace grainproof::input
