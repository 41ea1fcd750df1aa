// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads scene files that nobody would write, until one is found that is neither read soundly nor refused.
//   fuzz_reader SCENES [--inputs N] [--seed S] [--seconds T] [--keep FOLDER] [--speed]
// Exit codes: 0 nothing found, 1 found (the file and the complaint are printed and kept), 2 wrong call.
#include <sys/time.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "input/read_case.hpp"
#include "model/errors.hpp"
#include "tests/fuzz/mutator.hpp"
#include "tests/fuzz/one_input.hpp"

namespace {

using grainproof::fuzz::Answer;
using Clock = std::chrono::steady_clock;

/// CPU seconds for one input: no file of this size takes a hundredth of it.
constexpr int longest = 5;
constexpr std::uint64_t run_every = 20;

struct Wish {
  std::string scenes;
  std::string keep = ".";
  std::uint64_t inputs = 100'000;
  std::uint64_t seed = 1;
  double seconds = 0.0;
  bool speed = false;
};

std::string input_now;
std::string keep_in;

void keep(const char* what) {
  const auto path = std::filesystem::path(keep_in) / (std::string("found-") + what + ".toml");
  std::ofstream(path, std::ios::binary) << input_now;
  std::fprintf(stderr, "%s; the input is kept in %s\n", what, path.c_str());
}

/// Not what a handler may do by the book, but all that is left of a process that is lost.
void on_signal(int signal) {
  keep(signal == SIGPROF ? "hang" : "crash");
  std::_Exit(1);
}

/// On a stack of its own, since what overflows a stack has none left.
void watch_for_crashes_and_hangs() {
  static char room[1 << 16];
  const stack_t stack{room, 0, sizeof room};
  sigaltstack(&stack, nullptr);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGPROF}) {
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_ONSTACK;
    sigaction(signal, &action, nullptr);
  }
}

void give_time() {
  const itimerval timer{{0, 0}, {longest, 0}};
  setitimer(ITIMER_PROF, &timer, nullptr);
}

double since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

int fuzz(const Wish& wish) {
  grainproof::fuzz::Mutator mutator(grainproof::fuzz::small_scenes(wish.scenes), wish.seed);
  const auto began = Clock::now();
  std::uint64_t count = 0, read = 0;
  for (; count < wish.inputs && (wish.seconds == 0.0 || since(began) < wish.seconds); ++count) {
    input_now = mutator.next();
    if (count % 64 == 0) give_time();
    const auto judged = grainproof::fuzz::judge(input_now, count % run_every == 0);
    read += judged.answer == Answer::read;
    if (judged.complaint.empty()) continue;
    keep("complaint");
    std::printf("input %llu of seed %llu: %s\n", static_cast<unsigned long long>(count),
                static_cast<unsigned long long>(wish.seed), judged.complaint.c_str());
    return 1;
  }
  std::printf("%llu inputs, %llu read and %llu refused, nothing found; %.0f a second\n",
              static_cast<unsigned long long>(count), static_cast<unsigned long long>(read),
              static_cast<unsigned long long>(count - read), static_cast<double>(count) / since(began));
  return 0;
}

/// Scenes of the project, as they are but small, read over and over.
int measure(const Wish& wish) {
  const auto scenes = grainproof::fuzz::small_scenes(wish.scenes);
  const std::clock_t began = std::clock();
  std::size_t files = 0, expanded = 0;
  for (int round = 0; round < 20; ++round)
    for (const std::string& text : scenes) try {
        expanded +=
            grainproof::read_case_text(text, std::filesystem::path(wish.scenes) / "scene.toml").scenes.size();
        ++files;
      } catch (const grainproof::InputRefused&) {
      }
  const double seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  std::printf("%zu files, %zu scenes; %.0f files and %.0f scenes a CPU second\n", files, expanded,
              static_cast<double>(files) / seconds, static_cast<double>(expanded) / seconds);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Wish wish;
  CLI::App app("Reads scene files that nobody would write");
  app.add_option("scenes", wish.scenes, "Folder with the scenes to start from")->required();
  app.add_option("--inputs", wish.inputs, "How many");
  app.add_option("--seed", wish.seed, "Another seed, other inputs");
  app.add_option("--seconds", wish.seconds, "Stop earlier");
  app.add_option("--keep", wish.keep, "Where what is found is kept");
  app.add_flag("--speed", wish.speed, "Measure the reader on the scenes as they are");
  CLI11_PARSE(app, argc, argv);
  keep_in = wish.keep;
  watch_for_crashes_and_hangs();
  return wish.speed ? measure(wish) : fuzz(wish);
}
