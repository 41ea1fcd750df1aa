// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
// device_driver PRECISION PATH SCENE LAYERS STEPS [full] [ledger] [canonical] [pressed] [hoarding]: takes the
// steps and prints the digest. A program of its own, to be run with other environments and under oclgrind.
#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "device_fixture.hpp"
#include "opencl/cl.hpp"
#include "rare_scenes.hpp"
#include "varied_scenes.hpp"

/// Where oclgrind 21.10 looks for values that nobody wrote, it takes a buffer for the one whose number it has
/// got, and for no longer than that was. With [hoarding] no buffer is given back, so none has the number of
/// another.
static bool hoards = false;

extern "C" cl_int clReleaseMemObject(cl_mem buffer) {
  static const auto release = reinterpret_cast<cl_int (*)(cl_mem)>(dlsym(RTLD_NEXT, "clReleaseMemObject"));
  return hoards ? CL_SUCCESS : release(buffer);
}

namespace grainproof::opencl::testing {
namespace {

EngineOptions options_from(const std::string& precision, const std::string& path, bool full) {
  EngineOptions options = options_for(precision_named(precision).value());
  options.path = path == "small" ? Path::small : path.starts_with("dense") ? Path::dense : Path::zoned;
  // By name, not by the device: oclgrind says that it is a GPU.
  options.width = path == "dense_by_one" ? Width::one : Width::many;
  options.stages = full ? Stages::full : Stages::lean;
  options.work_group = 32;
  return options;
}

std::size_t touching_pairs(const std::vector<Particle>& bodies) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double reach = (bodies[i].diameter + bodies[j].diameter) / 2;
      pairs += (bodies[i].position - bodies[j].position).squaredNorm() < reach * reach ? 1 : 0;
    }
  return pairs;
}

/// Makes the spheres of a lattice so large that neighbours overlap a little, for a dozen steps bring none
/// together.
void press(Scene& scene) {
  for (Particle& body : scene.particles) {
    body.diameter = lattice_spacing + 0.3 * (body.diameter - 0.1);
    body.effect_diameter = 1.1 * body.diameter;
  }
  if (touching_pairs(scene.particles) == 0) throw std::runtime_error("nobody touches");
}

int drive(int argc, char** argv) {
  if (argc < 6) {
    std::fputs(
        "device_driver PRECISION PATH SCENE LAYERS STEPS [full] [ledger] [canonical] [pressed] [hoarding]\n",
        stderr);
    return 2;
  }
  const auto asked = [&](const char* word) {
    return std::any_of(argv + 6, argv + argc, [&](const char* one) { return one == std::string(word); });
  };
  hoards = asked("hoarding");
  OpenClEngine engine(options_from(argv[1], argv[2], asked("full")));
  Scene scene = any_scene(argv[3], std::stoi(argv[4]));
  if (asked("pressed")) press(scene);
  if (asked("canonical")) scene.run.order = SumOrder::canonical;
  const auto run = engine.start(scene, {.times = {}, .ledger = asked("ledger")});
  run->advance(std::stol(argv[5]));
  std::printf("digest %016llx\n", static_cast<unsigned long long>(run->digest()));
  return 0;
}

}  // namespace
}  // namespace grainproof::opencl::testing

int main(int argc, char** argv) {
  try {
    return grainproof::opencl::testing::drive(argc, argv);
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 1;
  }
}
