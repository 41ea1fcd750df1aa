// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "input/expectations.hpp"
#include "input/sweep.hpp"
#include "model/errors.hpp"

namespace grainproof {
namespace {

using input::Document;
using input::Reading;
using input::Table;
using input::WrittenExpectation;

constexpr std::int64_t schema = 1;

constexpr std::pair<std::string_view, Tier> tiers[] = {
    {"quick", Tier::quick}, {"standard", Tier::standard}, {"bulk", Tier::bulk}};

void check_top(const Table& file) {
  file.only({"schema", "title", "tier", "run", "domain", "bodies", "material", "contact", "particles", "wall",
             "field", "sweep", "expect", "verify"});
  file.at("schema").integer_within(schema, schema);
}

std::string read_no_peers(const Table& file) {
  const auto verify = file.find("verify");
  if (!verify) return "";
  const Table table = verify->table();
  table.only({"no_peers"});
  const auto reason = table.find("no_peers");
  return reason ? reason->text() : "";
}

bool expects_refusal(const Case& read) {
  return std::any_of(read.expectations.begin(), read.expectations.end(),
                     [](const Expectation& expectation) { return expectation.outcome == "refused"; });
}

void expand_into(Case& read, Document& document, const Reading& reading,
                 const std::vector<WrittenExpectation>& written) {
  const auto sweep_node = root(document).find("sweep");
  const input::Sweep sweep = sweep_node ? read_sweep(sweep_node->table(), document) : input::Sweep{};
  read.scenes = expand(document, sweep, reading);
  check_expectations(written, read.scenes);
}

}  // namespace

Case read_case_text(const std::string& text, const std::filesystem::path& name, const ReadOptions& options) {
  Document document = input::parse(text, name.string());
  const Table file = root(document);
  check_top(file);
  Case read;
  read.name = name.stem().string();
  const auto title = file.find("title");
  read.title = title ? title->text() : read.name;
  if (const auto tier = file.find("tier")) read.tier = tier->choice(tiers);
  read.no_peers_because = read_no_peers(file);
  const auto expect = file.find("expect");
  const auto written = read_expectations(expect ? expect->tables() : std::vector<input::Node>{}, options);
  for (const WrittenExpectation& one : written) read.expectations.push_back(one.expectation);
  try {
    expand_into(read, document, {options, name.parent_path()}, written);
  } catch (const InputRefused& refused) {
    if (!expects_refusal(read)) throw;
    read.scenes.clear();
    read.refused = refused.what();
  }
  return read;
}

Case read_case(const std::filesystem::path& path, const ReadOptions& options) {
  std::error_code ignored;
  std::ifstream stream(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, ignored) || !stream)
    throw InputRefused(path.string() + ":1:1: found no file that can be read; expected a scene file");
  std::ostringstream text;
  text << stream.rdbuf();
  return read_case_text(text.str(), path, options);
}

}  // namespace grainproof
