// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "comparisons/judging/exact.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace grainproof {
namespace {

constexpr std::size_t record_bytes = std::size_t{16} << 20;  // frames of one scene that are worth keeping

bool is_engine(const std::string& against) {
  return against.rfind("engine:", 0) == 0;
}

Observations failed(const std::string& message) {
  Observations none;
  none.outcome = {Outcome::Status::went_wrong, message, 0, 0.0, {}};
  return none;
}

std::vector<double> times_of(const Observations& seen) {
  std::vector<double> times;
  for (const Frame& frame : seen.frames) times.push_back(frame.time);
  return times;
}

/// At the frames' own times where curves are compared, or where the scalar is not told by name.
Observations closed_form(const Claim& claim, const Scene& scene, const Observations& seen) {
  Request request;
  if (claim.quantity->curve) request.times = times_of(seen);
  if (const Support support = claim.oracle->supports(scene, request); !support)
    throw std::runtime_error(support.because);
  Observations exact = claim.oracle->observe(scene, request);
  if (claim.quantity->curve || exact.scalars.contains(claim.says->quantity)) return exact;
  request.times = times_of(seen);
  return claim.oracle->observe(scene, request);
}

Observations stated(const Claim& claim) {
  Observations exact;
  if (claim.says->against.rfind("value:", 0) == 0)
    exact.scalars[claim.says->quantity] = std::stod(claim.says->against.substr(6));
  return exact;
}

std::string incomplete_frame(const Scene& scene, const Frame& frame) {
  if (frame.position.size() != scene.particles.size() || frame.velocity.size() != scene.particles.size())
    return "particles are missing";
  for (std::size_t i = 0; i < frame.position.size(); ++i)
    if (!frame.position[i].allFinite() || !frame.velocity[i].allFinite())
      return "particle " + std::to_string(scene.particles[i].id) + " has a number that is not finite";
  return {};
}

}  // namespace

std::size_t frame_bytes(const Scene& scene, const Request& request) {
  const double frames = request.every_step ? scene.run.end / scene.run.step
                                           : static_cast<double>(scene.run.sample_times.size());
  return static_cast<std::size_t>((frames + 2.0) *
                                  static_cast<double>(scene.particles.size() * 2 * sizeof(Vec3)));
}

std::vector<Observations> observe_chunk(const Case& subject, const Chunk& chunk, Engine& engine) {
  if (chunk.scenes.empty()) return {};
  std::vector<Scene> scenes;
  for (const std::size_t i : chunk.scenes) scenes.push_back(subject.scenes[i].scene);
  try {
    std::vector<Observations> seen = engine.observe_all(scenes, chunk.request);
    if (seen.size() == scenes.size()) return seen;
    return {scenes.size(), failed("the engine did not answer every scene")};
  } catch (const std::exception& failure) {
    return {scenes.size(), failed(failure.what())};
  }
}

Observations thinned(const Scene& scene, const Observations& seen) {
  Observations few = seen;
  const std::vector<std::int64_t> wanted = sample_steps(scene, {});
  std::erase_if(few.frames, [&](const Frame& frame) {
    return !std::binary_search(wanted.begin(), wanted.end(), frame.step);
  });
  return few;
}

std::string fault_of(const Scene& scene, const Observations& seen) {
  std::ostringstream text;
  text.precision(9);
  if (seen.outcome.status == Outcome::Status::went_wrong) {
    text << "went wrong at step " << seen.outcome.step << ", " << seen.outcome.time
         << " s: " << seen.outcome.reason;
    return text.str();
  }
  for (const Frame& frame : seen.frames) {
    const std::string fault = incomplete_frame(scene, frame);
    if (fault.empty()) continue;
    text << fault << " in the frame at " << frame.time << " s";
    return text.str();
  }
  if (seen.frames.empty()) return "the engine gave no frames";
  if (seen.frames.back().time >= scene.run.end - 1e-6 * scene.run.step) return {};
  text << "the last frame is at " << seen.frames.back().time << " s, before the end at " << scene.run.end
       << " s";
  return text.str();
}

ExactSide::ExactSide(const Case& subject, const Chunk& chunk, const std::vector<Claim>& claims,
                     Records& records)
    : subject_(subject), chunk_(chunk) {
  std::map<std::string, Question> questions;
  for (const Claim& claim : claims) {
    if (!claim.oracle || !is_engine(claim.says->against) || claim.quantity->search) continue;
    Question& question = questions[claim.says->against];
    question.oracle = claim.oracle;
    question.every_step |= claim.quantity->every_step;
    question.ledger |= claim.quantity->ledger;
    std::set_intersection(chunk.scenes.begin(), chunk.scenes.end(), claim.scenes.begin(), claim.scenes.end(),
                          std::inserter(question.scenes, question.scenes.end()));
  }
  for (const auto& [against, question] : questions) ask(against, question, records);
}

void ExactSide::ask(const std::string& against, const Question& question, Records& records) {
  Chunk missing{{{}, question.every_step, question.ledger}, {}};
  const bool special = question.every_step || question.ledger;
  std::map<std::size_t, Observations>& answers = engines_[against];
  for (const std::size_t i : question.scenes) {
    const auto known = records.find({against, i});
    if (special || known == records.end())
      missing.scenes.push_back(i);
    else
      answers[i] = known->second;
  }
  std::vector<Observations> fresh = observe_chunk(subject_, missing, *question.oracle);
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    const std::size_t i = missing.scenes[k];
    const bool keep = !special && frame_bytes(subject_.scenes[i].scene, missing.request) <= record_bytes;
    if (keep) records[{against, i}] = fresh[k];
    answers[i] = std::move(fresh[k]);
  }
}

Observations ExactSide::of(const Claim& claim, std::size_t at, const Observations& seen) const try {
  const Scene& scene = subject_.scenes[chunk_.scenes[at]].scene;
  if (!claim.oracle) return stated(claim);
  if (!is_engine(claim.says->against)) return closed_form(claim, scene, seen);
  const Observations& exact = engines_.at(claim.says->against).at(chunk_.scenes[at]);
  const std::string fault = fault_of(scene, exact);
  if (!fault.empty()) return failed(fault);
  return claim.quantity->every_step ? exact : thinned(scene, exact);
} catch (const std::exception& failure) {
  return failed(failure.what());
}

}  // namespace grainproof
