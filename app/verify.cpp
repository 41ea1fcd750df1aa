// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/verify.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "app/case_pool.hpp"
#include "app/engines.hpp"
#include "app/exit_code.hpp"
#include "app/oracles.hpp"
#include "app/progress.hpp"
#include "app/resources.hpp"
#include "app/scene_choice.hpp"
#include "comparisons/judge.hpp"
#include "model/errors.hpp"
#include "report/claims.hpp"
#include "report/files.hpp"
#include "report/html.hpp"
#include "report/results_json.hpp"
#include "report/verdict_text.hpp"

namespace grainproof::app {
namespace {

namespace fs = std::filesystem;

/// The dearest tier that a run of this kind has in it.
Tier dearest(const VerifyOptions& options) {
  if (options.bulk) return Tier::bulk;
  return options.quick ? Tier::quick : Tier::standard;
}

std::vector<fs::path> case_files(const VerifyOptions& options, const fs::path& data) {
  if (options.cases.empty()) return known_cases(data);
  std::vector<fs::path> files;
  for (const std::string& name : options.cases) files.push_back(find_case(data, name));
  return files;
}

const char* flag_for(Tier tier) {
  return tier == Tier::bulk ? "--bulk runs them, and so does naming them"
                            : "without --quick they run, and if they are named";
}

void say_what_is_left_out(const std::vector<std::pair<std::string, Tier>>& left, Progress& progress) {
  for (const Tier tier : {Tier::standard, Tier::bulk}) {
    std::string names;
    for (const auto& [name, own] : left)
      if (own == tier) names.append(names.empty() ? "" : ", ").append(name);
    if (!names.empty()) progress.say("left out: " + names + "; " + flag_for(tier));
  }
}

const char* word_for(Tier tier) {
  if (tier == Tier::bulk) return "bulk";
  return tier == Tier::quick ? "quick" : "standard";
}

int list_cases(const fs::path& data, Terminal& terminal) {
  report::TextTable table({{"case"}, {"tier"}, {"title"}});
  for (const fs::path& file : known_cases(data)) {
    const Case subject = read_case(file, reading_options());
    table.add({subject.name, word_for(subject.tier), subject.title});
  }
  terminal.out << table.text(terminal.paint());
  return all_held;
}

/// Every case is read before any runs, so that a refusal costs nothing. A case that is named runs whatever
/// its tier.
std::vector<Case> read_cases(const VerifyOptions& options, const fs::path& data, Progress& progress) {
  std::vector<Case> cases;
  std::vector<std::pair<std::string, Tier>> left;
  for (const fs::path& file : case_files(options, data)) {
    Case subject = read_case(file, reading_options());
    if (subject.expectations.empty())
      throw InputRefused(file.string() +
                         ": found no [[expect]], so there is nothing to judge; expected a claim" +
                         " (docs/scene.md), or: grainproof run " + file.string());
    if (options.cases.empty() && subject.tier > dearest(options))
      left.emplace_back(subject.name, subject.tier);
    else
      cases.push_back(std::move(subject));
  }
  say_what_is_left_out(left, progress);
  if (cases.empty()) throw InputRefused("no case to verify in " + (data / "scenes").string());
  return cases;
}

std::vector<Made> engines_asked_for(const VerifyOptions& options, const fs::path& data) {
  std::vector<Made> engines;
  for (const std::string& name : options.engines.empty() ? engines_to_verify() : options.engines)
    for (Made& made : make_engines(name, {data, "", options.device})) engines.push_back(std::move(made));
  return engines;
}

/// The row of an engine that is not asked about a case, with the reason.
Row unsupported_row(const Case& subject, const std::string& engine, const std::string& because) {
  Row row;
  row.case_name = subject.name;
  row.engine = engine;
  row.verdict = Verdict::unsupported;
  row.reason = because;
  return row;
}

std::vector<Row> judge_one(Judge& judge, const Case& subject, const Made& made, const Tell& tell) {
  if (!made.engine) return {unsupported_row(subject, made.name, "not available here: " + made.because)};
  if (made.peer && !subject.no_peers_because.empty())
    return {unsupported_row(subject, made.name, subject.no_peers_because)};
  const std::string what = subject.name + " on " + made.name;
  tell([](Progress& progress) { progress.begin(); });
  return judge.rows(*made.engine, [&](std::size_t done, std::size_t total) {
    const double share = static_cast<double>(done) / static_cast<double>(total);
    tell([what, share](Progress& progress) { progress.show(what, share); });
  });
}

/// Mixed precision has the laws' code of single and the positions of double: unless it is named, a quick run
/// asks it about the cases that have a claim for it alone, and a bulk run about no long one.
bool is_spared(const Case& subject, const Made& made, const VerifyOptions& options) {
  if (!options.engines.empty() || made.name != "opencl:mixed") return false;
  const bool has_its_own =
      std::any_of(subject.expectations.begin(), subject.expectations.end(), [](const Expectation& claim) {
        return claim.engines.size() == 1 && claim.engines.front() == "opencl:mixed";
      });
  return subject.tier == Tier::bulk || (options.quick && !has_its_own);
}

std::vector<Row> judge_case(const Case& subject, const std::vector<Made>& engines, const Oracles& oracles,
                            const VerifyOptions& options, const Tell& tell) {
  Judge judge(subject, oracles);
  std::vector<Row> rows;
  for (const Made& made : engines) {
    if (is_spared(subject, made, options)) continue;
    const std::string line = subject.name + " on " + made.name + " …";
    tell([line](Progress& progress) {
      if (!progress.on_terminal()) progress.say(line);
    });
    const std::vector<Row> more = judge_one(judge, subject, made, tell);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  tell([](Progress& progress) { progress.clear(); });
  return rows;
}

void say_what_is_missing(const std::vector<Made>& engines, Progress& progress) {
  for (const Made& made : engines)
    if (!made.engine) progress.say(made.name + " is not available: " + made.because);
  if (std::none_of(engines.begin(), engines.end(), [](const Made& made) { return made.engine != nullptr; }))
    throw InputRefused("none of the engines asked for is available; grainproof doctor says what to install");
}

void write_results(const VerifyOptions& options, const std::vector<report::CaseReport>& cases,
                   const std::vector<Row>& rows) {
  const report::Machine machine = report::this_machine();
  const std::string json = report::results_json(rows, machine).dump(2) + "\n";
  if (!options.json.empty()) report::write_file(options.json, json);
  if (options.out.empty()) return;
  report::write_file(options.out / "results.json", json);
  report::write_file(options.out / "report.html", report::html(cases, machine));
}

/// Whoever reads the exit code alone would take a run without a verdict for one in which all held.
int code_for(const std::vector<Row>& rows) {
  const Verdict worst = report::worst(rows);
  if (worst == Verdict::fail) return verdict_failed;
  if (worst == Verdict::pass) return all_held;
  throw InputRefused(
      std::string("nothing was judged: found ") +
      (rows.empty() ? "no claim that an engine asked for is held to"
                    : "only what is not supported, as said above") +
      "; expected other cases (grainproof verify --list) or other engines (grainproof doctor)");
}

}  // namespace

int verify(const VerifyOptions& options, Terminal& terminal) {
  const auto began = std::chrono::steady_clock::now();
  Progress progress(terminal.err, terminal.err_is_terminal, terminal.quiet);
  const fs::path data = data_root();
  if (options.list) return list_cases(data, terminal);
  const std::vector<Made> engines = engines_asked_for(options, data);
  const std::vector<Case> cases = read_cases(options, data, progress);
  say_what_is_missing(engines, progress);

  OracleTable oracles({data, "", options.device});
  const Oracles find = [&](const std::string& against) { return oracles.find(against); };
  CasePool pool(cases.size(), options.jobs > 0 ? options.jobs : usual_threads(),
                [&](std::size_t index, const Tell& tell) {
                  return judge_case(cases[index], engines, find, options, tell);
                });
  std::vector<report::CaseReport> reports;
  std::vector<Row> all;
  for (const Case& subject : cases) {
    const std::vector<Row> rows = pool.next(progress);
    terminal.out << report::case_text(rows, subject.title, terminal.paint()) << std::flush;
    all.insert(all.end(), rows.begin(), rows.end());
    reports.push_back({subject.title, rows});
  }
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  terminal.out << report::failures_text(all, terminal.paint())
               << report::summary_text(all, wall_s, terminal.paint());
  write_results(options, reports, all);
  return code_for(all);
}

}  // namespace grainproof::app
