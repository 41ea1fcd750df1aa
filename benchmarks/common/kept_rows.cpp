// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "benchmarks/common/kept_rows.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "model/errors.hpp"
#include "report/files.hpp"

namespace grainproof::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string line_of(const std::string& name, const MeasuredRow& row) {
  return json{{"name", name}, {"values", row.values}}.dump() + "\n";
}

bool all_finite(const MeasuredRow& row) {
  return std::ranges::all_of(row.values, [](const auto& value) { return std::isfinite(value.second); });
}

}  // namespace

KeptRows::KeptRows(fs::path file, std::string stamp) : file_(std::move(file)), stamp_(std::move(stamp)) {
  read();
  write_anew();
}

void KeptRows::read() {
  std::ifstream file(file_);
  std::string line;
  bool own = false;
  for (bool first = true; std::getline(file, line); first = false) {
    const json kept = json::parse(line, nullptr, false);
    if (first)
      own = kept.is_object() && kept.value("stamp", "") == stamp_;
    else if (!own)
      ++dropped_;
    else if (kept.is_object() && kept.contains("name") && kept.contains("values"))
      found_[kept.at("name")] = {kept.at("values"), ""};
  }
}

/// With whole lines only, so that the next one begins a line. Under a name of its own first.
void KeptRows::write_anew() const {
  std::string text = json{{"stamp", stamp_}}.dump() + "\n";
  for (const auto& [name, row] : found_) text += line_of(name, row);
  const fs::path unfinished = file_.string() + ".new";
  report::write_file(unfinished, text);
  fs::rename(unfinished, file_);
}

void KeptRows::keep(const std::string& name, const MeasuredRow& row) const {
  if (!row.failed.empty() || !all_finite(row)) return;
  std::ofstream file(file_, std::ios::app);
  file << line_of(name, row) << std::flush;
  if (!file) throw EngineFailed("cannot write " + file_.string());
}

void KeptRows::remove() const {
  fs::remove(file_);
}

}  // namespace grainproof::bench
