// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "app/bench_suites.hpp"

namespace grainproof::app {
namespace {

using nlohmann::json;

/// Bodies of each arrangement, so that --most leaves out what is larger.
struct Arrangement {
  const char* name;
  std::int64_t particles;
};
constexpr std::array arrangements{
    Arrangement{"wall", 1},       Arrangement{"settling", 1},      Arrangement{"pair", 2},
    Arrangement{"chain", 8},      Arrangement{"random_8", 24},     Arrangement{"random_10", 24},
    Arrangement{"random_12", 24}, Arrangement{"face_centred", 32}, Arrangement{"simple_cubic", 64}};

std::vector<std::string> arrangements_within(const BenchOptions& options) {
  std::vector<std::string> names;
  for (const Arrangement& one : arrangements)
    if (one.particles >= options.least && (options.most == 0 || one.particles <= options.most))
      names.emplace_back(one.name);
  if (names.empty()) names.emplace_back("pair");
  return names;
}

/// Least share of a contact that is stable, by integrator, arrangement and damping, over masses, stiffnesses,
/// friction and engines; and the least that `run` permits.
void add_safe_shares(BenchSession& session, const std::vector<json>& rows) {
  std::map<std::vector<std::string>, json> shares;
  std::vector<std::vector<std::string>> order;
  for (const json& row : rows) {
    const std::string restitution = row.at("restitution").is_string()
                                        ? row.at("restitution").get<std::string>()
                                        : row.at("restitution").dump();
    const std::vector<std::string> of{row.at("integrator"), row.at("scene"), restitution};
    const double share = row.at("share_of_contact"),
                 permitted = row.at("permitted_s").get<double>() / row.at("contact_s").get<double>();
    if (!shares.contains(of)) {
      order.push_back(of);
      shares[of] = {{"suite", "stability"}, {"integrator", of[0]}, {"scene", of[1]},
                    {"restitution", of[2]}, {"share", share},      {"permitted_share", permitted}};
    }
    shares[of]["share"] = std::min(shares[of]["share"].get<double>(), share);
    shares[of]["permitted_share"] = std::min(shares[of]["permitted_share"].get<double>(), permitted);
  }
  for (const auto& of : order) session.extra["safe_shares"].push_back(shares[of]);
}

/// How far predicted and measured limits are apart at worst, for each bar; and rows where `run` would permit
/// more than was measured to be stable.
void add_agreement(BenchSession& session, const std::vector<json>& rows) {
  std::map<double, json> bars;
  for (const json& row : rows) {
    const double bar = row.at("bar"), error = row.at("error");
    json& one = bars[bar];
    if (one.is_null())
      one = {{"suite", "stability"}, {"bar", bar},  {"worst", 0.0},
             {"points", 0},          {"beyond", 0}, {"permitted_above", 0}};
    one["worst"] = std::max(one["worst"].get<double>(), error);
    one["points"] = one["points"].get<int>() + 1;
    if (!(error <= bar)) one["beyond"] = one["beyond"].get<int>() + 1;
    // What the bisection may miss by itself is not the guard's.
    if (row.at("permitted_s").get<double>() > row.at("limit_s").get<double>() * (1.0 + bar))
      one["permitted_above"] = one["permitted_above"].get<int>() + 1;
  }
  for (const auto& [bar, one] : bars) session.extra["agreement"].push_back(one);
}

/// How far they are apart at worst in each class of cases; a rate of growth is one of its own, since it is
/// harder to measure than a limit.
void add_worst(BenchSession& session, const std::vector<json>& rows) {
  std::map<std::vector<std::string>, json> classes;
  for (const json& row : rows) {
    const bool grows = row.contains("growth_a_step");
    const std::vector<std::string> of{row.at("scene"), row.at("friction"), row.at("engine"),
                                      row.at("precision"), grows ? "growth" : "limit"};
    json& one = classes[of];
    if (one.is_null())
      one = {{"suite", "stability"}, {"scene", of[0]}, {"friction", of[1]}, {"engine", of[2]},
             {"precision", of[3]},   {"what", of[4]},  {"points", 0},       {"worst", 0.0}};
    one["points"] = one["points"].get<int>() + 1;
    one["worst"] = std::max(one["worst"].get<double>(), row.at("error").get<double>());
  }
  for (const auto& [of, one] : classes) session.extra["worst"].push_back(one);
}

}  // namespace

void measure_stability(BenchSession& session) {
  session.run({.suite = "stability",
               .what = "largest stable steps",
               .scenes = arrangements_within(session.options()),
               .engines = session.engines(),
               .threads = session.options().threads,
               .rounds = 1});
  std::vector<json> rows;
  for (const json& row : rows_of(session.all()))
    if (row.at("suite") == "stability" && row.at("status") == "completed" && row.contains("predicted_s"))
      rows.push_back(row);
  add_safe_shares(session, rows);
  add_agreement(session, rows);
  add_worst(session, rows);
}

}  // namespace grainproof::app
