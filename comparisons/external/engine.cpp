// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/external/engine.hpp"

#include <chrono>
#include <fstream>
#include <utility>

#include "comparisons/external/frames_csv.hpp"
#include "comparisons/external/scene_json.hpp"
#include "comparisons/peers/process.hpp"
#include "model/errors.hpp"

namespace grainproof {
namespace {

constexpr int went_wrong = 3;

}  // namespace

ExternalEngine::ExternalEngine(std::string command) : command_(std::move(command)) {}

Support ExternalEngine::supports(const Scene& scene, const Request& request) const {
  if (request.ledger) return Support::no("an external command gives no energy and impulse ledger");
  if (scene.orientation != OrientationUpdate::none)
    return Support::no("an external command gives no orientations");
  if (!scene.remembered.empty())
    return Support::no("an external command is not told what contacts remember at the start");
  return {};
}

Observations ExternalEngine::observe(const Scene& scene, const Request& request) {
  if (const Support support = supports(scene, request); !support) throw EngineFailed(support.because);
  const std::lock_guard lock(turn_);
  const TemporaryFolder folder;
  const std::filesystem::path input = folder.path() / "scene.json";
  const std::filesystem::path said = folder.path() / "output.txt";
  std::ofstream(input) << external::scene_json(scene, request).dump(1) << '\n';
  const auto began = std::chrono::steady_clock::now();
  const int status = run_program({"/bin/sh", "-c", command_ + " \"$0\" \"$1\"", input, folder.path()},
                                 std::filesystem::current_path(), said);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  if (status != 0 && status != went_wrong)
    throw EngineFailed(command_ + " ended with status " + std::to_string(status) + ":\n" +
                       last_lines(said, 10));
  Observations seen;
  if (status == went_wrong)
    seen.outcome = {Outcome::Status::went_wrong, last_lines(said, 10), 0, 0.0, {}};
  else
    seen = external::read_frames(folder.path() / "frames.csv", scene, sample_steps(scene, request));
  seen.provenance = {name(), "double", "", "", "", 0x1p-53};
  seen.wall_s = wall_s;
  return seen;
}

}  // namespace grainproof
