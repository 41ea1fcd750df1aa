// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <functional>

#include "app/bench.hpp"
#include "app/compare.hpp"
#include "app/doctor.hpp"
#include "app/engines.hpp"
#include "app/exit_code.hpp"
#include "app/run_scene.hpp"
#include "app/verify.hpp"
#include "model/errors.hpp"

namespace grainproof::app {
namespace {

/// The chosen command, with its options read.
using Command = std::function<int(Terminal&)>;

constexpr const char* exit_codes =
    "Exit codes: 0 all held, 1 a verdict failed, 2 the input was refused or nothing was judged,\n"
    "3 a run went wrong.\n"
    "Results go to standard output, progress to standard error.";

constexpr const char* sweep_help = "Which scene of a sweep, from 1 (default: the first)";
constexpr const char* device_help =
    "OpenCL device by number or part of its name (see doctor; default: first GPU, else CPU)";

/// A subcommand that --quiet works on too, whether before it or after.
CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& what,
                      const std::string& examples) {
  CLI::App* command = program.add_subcommand(name, what);
  command->footer("Examples:\n" + examples + "\n" + exit_codes);
  command->fallthrough();
  return command;
}

void add_verify(CLI::App& program, Command& chosen) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      add_command(program, "verify", "Judge engines by cases: errors, orders, tolerances, verdicts",
                  "  grainproof verify\n"
                  "  grainproof verify normal_collision settling --engines reference,opencl\n"
                  "  grainproof verify my_case.toml --engines 'external:python3 my_code.py'\n"
                  "  grainproof verify --out results --json results.json\n");
  command->add_option("cases", options->cases, "Names of cases, or scene files (default: every case)");
  command->add_flag("--list", options->list, "Name the cases there are, with tier and title, and run none");
  command->add_option("--engines", options->engines, engine_help())
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  command->add_option("--device", options->device, device_help);
  command->add_option("--json", options->json, "Write the results as JSON")->type_name("FILE");
  command->add_option("--out", options->out, "Write results.json and report.html with plots here")
      ->type_name("DIR");
  CLI::Option* quick =
      command->add_flag("--quick", options->quick, "Only the quick cases: under two minutes on two cores");
  command->add_flag("--bulk", options->bulk, "The cases of 10 000 bodies too: under an hour on two cores")
      ->excludes(quick);
  command
      ->add_option("--jobs", options->jobs,
                   "Cases judged at the same time (default: as many as cores, 4 at most)")
      ->check(CLI::Range(1, 64))
      ->type_name("N");
  command->callback(
      [&chosen, options] { chosen = [options](Terminal& terminal) { return verify(*options, terminal); }; });
}

void add_books_and_checkpoints(CLI::App& command, const std::shared_ptr<RunOptions>& options) {
  auto* ledger = command.add_flag("--ledger", options->ledger,
                                  "Keep the ledger of energies and impulses, and so walls.csv, also of 512 "
                                  "particles and more: several times slower on a device");
  command
      .add_flag("--no-ledger", options->no_ledger, "Keep none of fewer either, nor where a claim needs it")
      ->excludes(ledger);
  command.add_option("--from", options->from, "Go on from a checkpoint of this scene")->type_name("FILE");
  command
      .add_option("--checkpoint-every", options->checkpoint_every,
                  "With --out: write checkpoint.h5 every so many steps (1000) or seconds (30s)")
      ->type_name("N");
}

void add_run(CLI::App& program, Command& chosen) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      add_command(program, "run", "Run one scene on one engine",
                  "  grainproof run settling\n"
                  "  grainproof run settling --engine opencl --precision double --out settling --csv\n"
                  "  grainproof run normal_collision --nth 17 --json summary.json\n");
  command->add_option("scene", options->scene, "Name of a case, or a scene file")->required();
  command->add_option("--engine", options->engine, engine_help())->type_name("NAME")->capture_default_str();
  command->add_option("--precision", options->precision, "single, mixed or double, for opencl")
      ->type_name("P");
  command->add_option("--device", options->device, device_help);
  CLI::Option* out = command
                         ->add_option("--out", options->out,
                                      "Write summary.json, walls.csv, frames as .vtp and frames.pvd here")
                         ->type_name("DIR");
  command->add_option("--json", options->json, "Write the summary as JSON")->type_name("FILE");
  command
      ->add_flag("--csv", options->csv,
                 "With --out: also frames.csv, time,id,x,y,z,vx,vy,vz, with rotation wx,wy,wz, with "
                 "orientation qw,qx,qy,qz, in full precision")
      ->needs(out);
  add_books_and_checkpoints(*command, options);
  command->add_flag("--no-self-test", options->no_self_test,
                    "Do not test the kernels on a device that has not been tested yet");
  command->add_flag("--no-sentinels", options->no_sentinels,
                    "Do not look out for energy from nowhere, nor keep the last good state");
  command->add_flag("--force", options->force, "Run although the step is above the stability limit");
  command->add_option("--nth", options->nth, sweep_help)->type_name("N");
  command->callback([&chosen, options] {
    chosen = [options](Terminal& terminal) { return run_scene(*options, terminal); };
  });
}

void add_compare(CLI::App& program, Command& chosen) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      add_command(program, "compare", "Run one scene on several engines, side by side",
                  "  grainproof compare normal_collision --engines reference,opencl:double\n"
                  "  grainproof compare settling --engines reference,opencl,liggghts --out apart\n"
                  "  grainproof compare settling --exact opencl:double --other settling_canonical.toml\n");
  command->add_option("scene", options->scene, "Name of a case, or a scene file")->required();
  command->add_option("--engines", options->engines, "Default: reference,opencl. " + engine_help())
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  command
      ->add_option("--exact", options->exact,
                   "Instead of --engines: the first step and particle in which A and B differ by a bit; or A "
                   "alone, with --other")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  command->add_option("--other", options->other, "With --exact: the second runs this scene, of the same ids")
      ->type_name("SCENE");
  command->add_option("--device", options->device, device_help);
  command->add_option("--out", options->out, "Write compare.json and every engine's frames here")
      ->type_name("DIR");
  command->add_option("--json", options->json, "Write the differences as JSON")->type_name("FILE");
  command->add_flag("--force", options->force, "Run although the step is above the stability limit");
  command->add_option("--nth", options->nth, sweep_help)->type_name("N");
  command->callback(
      [&chosen, options] { chosen = [options](Terminal& terminal) { return compare(*options, terminal); }; });
}

void add_bench(CLI::App& program, Command& chosen) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = add_command(program, "bench", "Measure speed and accuracy, and draw them",
                                  "  grainproof bench --quick\n"
                                  "  grainproof bench cundall scaling --most 1000000 --out speed\n"
                                  "  grainproof bench peers --json peers.json\n");
  command->add_option("suites", options->suites, "Suites (default: every one):\n" + suite_help());
  command->add_flag("--quick", options->quick, "Small scenes and short measurements");
  command->add_option("--least", options->least, "Particles of the smallest scene")->type_name("N");
  command->add_option("--most", options->most, "Particles of the largest scene")->type_name("N");
  command->add_option("--rounds", options->rounds, "Measurements of each subject")->type_name("N");
  command->add_option("--seconds", options->seconds, "How long one measurement lasts")->type_name("S");
  command
      ->add_option("--threads", options->threads, "Rows of stability measured at once (default: a core each)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("N");
  command->add_option("--engines", options->engines, "Of ours: reference, opencl, opencl:single …")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B");
  command->add_option("--device", options->device, device_help);
  command->add_option("--json", options->json, "Write the results as JSON")->type_name("FILE");
  command->add_option("--out", options->out, "Write results.json, tables.txt and SVG plots here")
      ->type_name("DIR");
  command->add_option("--cache", options->cache, "Where settled beds are kept")->type_name("DIR");
  command->callback(
      [&chosen, options] { chosen = [options](Terminal& terminal) { return bench(*options, terminal); }; });
}

void add_doctor(CLI::App& program, Command& chosen) {
  CLI::App* command =
      add_command(program, "doctor", "What this machine offers, and what to install for the rest",
                  "  grainproof doctor\n");
  command->callback([&chosen] { chosen = doctor; });
}

/// CLI11's message, but for a first word that is no command.
std::string explained(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<std::string> left = program.remaining();
  if (!program.get_subcommands().empty() || left.empty() || left.front().starts_with('-'))
    return error.what() + std::string("; --help says what there is");
  std::string commands;
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; }))
    commands += (commands.empty() ? "" : ", ") + command->get_name();
  return "no command " + left.front() + "; expected one of " + commands;
}

/// Errors of the command line are refusals of input.
int refuse(const CLI::App& program, const CLI::ParseError& error, Terminal& terminal) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
    program.exit(error, terminal.out, terminal.err);  // --help or --version
    return all_held;
  }
  terminal.err << "grainproof: " << explained(program, error) << std::endl;
  return input_refused;
}

int guarded(const Command& command, Terminal& terminal) {
  try {
    return command(terminal);
  } catch (const InputRefused& refusal) {
    terminal.err << "grainproof: " << refusal.what() << std::endl;
    return input_refused;
  } catch (const std::exception& failure) {
    terminal.err << "grainproof: " << failure.what() << std::endl;
    return run_went_wrong;
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv, Terminal& terminal) {
  CLI::App program("Verification harness for the Discrete Element Method", "grainproof");
  Command chosen;
  program.add_flag("-q,--quiet", terminal.quiet, "No progress on standard error");
  program.set_version_flag("--version", "grainproof " GRAINPROOF_VERSION);
  program.footer(std::string("Each command explains itself: grainproof verify --help\n") + exit_codes);
  program.require_subcommand(0, 1);
  add_verify(program, chosen);
  add_run(program, chosen);
  add_compare(program, chosen);
  add_bench(program, chosen);
  add_doctor(program, chosen);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return refuse(program, error, terminal);
  }
  if (chosen) return guarded(chosen, terminal);
  terminal.err << program.help();
  return input_refused;
}

}  // namespace grainproof::app
