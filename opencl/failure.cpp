// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/failure.hpp"

#include <sstream>

#include "model/errors.hpp"
#include "opencl/bytes.hpp"
#include "opencl/pair_laws.hpp"

namespace grainproof::opencl {
namespace {

constexpr const char* face_names[6] = {"lower x", "upper x", "lower y", "upper y", "lower z", "upper z"};

std::string advice(const Scene& scene, bool left) {
  std::ostringstream text;
  text << "; the likely cause is " << (left ? "that no wall is there, or " : "")
       << "a step too large for this stiffness: the step is " << scene.run.step << " s";
  const double contact = shortest_contact(scene);
  if (contact > 0.0) text << ", the shortest undamped contact " << contact << " s";
  return text.str();
}

std::string described(const Scene& scene, std::size_t i, const cl_int4& fault) {
  std::ostringstream text;
  text << "particle " << scene.particles[i].id;
  const cl_int other = fault.s[2];
  switch (fault.s[1]) {
    case not_a_number:
      text << " has a position or velocity that is not a number, or left the domain by far in one step";
      break;
    case left_domain:
      text << " left the domain through the " << face_names[other] << " face";
      break;
    case leapt:
      text << " moved by more than its radius in one step, and so may pass through what it should hit";
      break;
    default:
      text << " overlaps " << (other >= 0 ? "particle " : "wall ");
      if (other >= 0)
        text << scene.particles[static_cast<std::size_t>(other)].id;
      else
        text << scene.walls[static_cast<std::size_t>(-1 - other)].name;
      text << " by more than " << scene.run.overlap_limit << " of the smaller radius";
  }
  return text.str() + advice(scene, fault.s[1] == left_domain);
}

}  // namespace

void throw_failure(const Scene& scene, cl_int step, const Bytes& faults, std::int64_t first_step) {
  const std::int64_t at = first_step + step;
  const double time = static_cast<double>(at) * scene.run.step;
  for (std::size_t i = 0; i < scene.particles.size(); ++i) {
    const auto fault = value_at<cl_int4>(faults, i);
    if (fault.s[0] != step) continue;
    std::vector<std::int64_t> ids{scene.particles[i].id};
    if (fault.s[1] == too_deep && fault.s[2] >= 0)
      ids.push_back(scene.particles[static_cast<std::size_t>(fault.s[2])].id);
    throw RunWentWrong(described(scene, i, fault), at, time, ids);
  }
  throw EngineFailed("a fault at step " + std::to_string(step) + " was signalled but no particle has it");
}

}  // namespace grainproof::opencl
