// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/bench.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/bench_long.hpp"
#include "app/bench_roofline.hpp"
#include "app/bench_session.hpp"
#include "app/bench_suites.hpp"
#include "app/bench_tables.hpp"
#include "app/bench_work_precision.hpp"
#include "app/exit_code.hpp"
#include "app/resources.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"
#include "report/bench_page.hpp"
#include "report/files.hpp"
#include "report/run_summary.hpp"

namespace grainproof::app {
namespace {

namespace fs = std::filesystem;

std::vector<Suite> suites_asked_for(const std::vector<std::string>& names) {
  const auto known = bench_suites();
  if (names.empty()) return {known.begin(), known.end()};
  std::vector<Suite> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const Suite& one) { return one.name == name; });
    if (found == known.end()) throw InputRefused("no suite " + name + "; there are\n" + suite_help());
    chosen.push_back(*found);
  }
  return chosen;
}

/// A Python that has what the plots need: the first on the path may be one of the user's own.
std::optional<std::string> python_with_matplotlib() {
  const TemporaryFolder folder;
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (run_program({python, "-c", "import matplotlib, numpy"}, folder.path(), folder.path() / "output") == 0)
      return python;
  return std::nullopt;
}

/// Plots are a picture of results.json: without Python the numbers are all there.
void draw_plots(const fs::path& out, Progress& progress) {
  const auto python = python_with_matplotlib();
  if (!python) {
    progress.say(
        "no plots: Python with matplotlib and numpy is missing; on Debian: apt-get install "
        "python3-matplotlib python3-numpy");
    return;
  }
  const TemporaryFolder folder;
  const std::vector<std::string> command{*python, (data_root() / "benchmarks" / "plots.py").string(),
                                         (fs::absolute(out) / "results.json").string(),
                                         fs::absolute(out).string()};
  if (run_program(command, folder.path(), folder.path() / "output") != 0)
    throw EngineFailed("the plots failed:\n" + last_lines(folder.path() / "output", 5));
}

/// The pictures of the folder, in the order of their names.
std::vector<std::pair<std::string, std::string>> pictures_in(const fs::path& out) {
  std::vector<std::pair<std::string, std::string>> pictures;
  for (const fs::directory_entry& entry : fs::directory_iterator(out)) {
    if (entry.path().extension() != ".svg") continue;
    std::ifstream file(entry.path());
    std::ostringstream text;
    text << file.rdbuf();
    pictures.emplace_back(entry.path().stem().string(), text.str());
  }
  std::sort(pictures.begin(), pictures.end());
  return pictures;
}

nlohmann::json results_of(const BenchSession& session) {
  nlohmann::json results = session.extra;
  results["schema"] = 1;
  results["machine"] = report::machine_json(report::this_machine());
  results["results"] = rows_of(session.all());
  add_shares(results["results"]);
  add_local_orders(results["results"]);
  add_verdicts(results["results"]);
  return results;
}

/// Also while suites are being measured: a session that is cut short has its rows.
void write_json(const BenchOptions& options, const BenchSession& session, bool complete) {
  nlohmann::json results = results_of(session);
  results["complete"] = complete;
  const std::string json = results.dump(2) + "\n";
  if (!options.json.empty()) report::write_file(options.json, json);
  if (!options.out.empty()) report::write_file(options.out / "results.json", json);
}

void write_results(const BenchOptions& options, const BenchSession& session, const std::string& tables,
                   Progress& progress) {
  write_json(options, session, true);
  if (options.out.empty()) return;
  report::write_file(options.out / "tables.txt", tables);
  draw_plots(options.out, progress);
  report::write_file(options.out / "index.html",
                     report::bench_page(report::this_machine(), pictures_in(options.out), tables));
}

}  // namespace

std::string suite_help() {
  std::string text;
  for (const Suite& suite : bench_suites()) text += std::string("  ") + suite.name + ": " + suite.what + "\n";
  return text;
}

int bench(const BenchOptions& options, Terminal& terminal) {
  Progress progress(terminal.err, terminal.err_is_terminal, terminal.quiet);
  const std::vector<Suite> suites = suites_asked_for(options.suites);
  BenchSession session(options, progress);
  session.has_more = [&] { write_json(options, session, false); };
  measure_roofline(session);
  std::string tables;
  for (const Suite& suite : suites) {
    suite.measure(session);
    const nlohmann::json results = results_of(session);
    terminal.out << suite_text(suite, results, terminal.paint()) << std::endl;
    tables += suite_text(suite, results, {}) + "\n";
  }
  write_results(options, session, tables, progress);
  return all_held;
}

}  // namespace grainproof::app
