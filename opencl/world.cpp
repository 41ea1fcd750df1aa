// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/world.hpp"

#include <algorithm>

#include "opencl/bytes.hpp"
#include "opencl/corrections.hpp"

namespace grainproof::opencl {
namespace {

Bytes repeated(const Bytes& bytes, std::size_t times) {
  Bytes all;
  all.reserve(bytes.size() * times);
  for (std::size_t k = 0; k < times; ++k) all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

}  // namespace

World make_world(Workshop& workshop, const SceneImage& image, const Decoder& decoder,
                 const BuildOptions& options) {
  const std::size_t turning = options.rotation ? image.padded : 1;
  const std::size_t remembering = options.remembers() ? image.padded : 1;
  const std::size_t booked = options.ledger ? image.padded : 1;
  const std::size_t booked_walls =
      options.ledger ? std::max<std::size_t>(image.padded * image.near.count(), 1) : 1;
  const auto memories = [&](std::size_t count) {
    return Bytes(std::max<std::size_t>(count, 1) * memory_bytes(options, decoder));
  };
  const auto vectors = [&](std::size_t count) { return Bytes(count * decoder.vector_bytes()); };
  World w;
  w.box = workshop.upload(image.box);
  w.constants = workshop.upload(image.constants);
  w.laws = workshop.upload(image.laws);
  w.planes = workshop.upload(image.planes);
  w.rectangles = workshop.upload(image.rectangles);
  w.cylinders = workshop.upload(image.cylinders);
  w.materials = workshop.upload(image.materials);
  w.reaches = workshop.upload(image.reaches);
  w.drag_rates = workshop.upload(image.drag_rates);
  w.gravity_table = workshop.upload(vectors(1));
  w.stands = workshop.upload(vectors(1));
  w.positions = workshop.upload(image.positions);
  w.velocities = workshop.upload(image.velocities);
  w.rests = workshop.upload(vectors(image.padded));
  w.accelerations = workshop.upload(vectors(image.padded));
  w.reported = workshop.upload(image.velocities);
  w.tallies = workshop.upload(Bytes(booked * decoder.tally_bytes()));
  w.sums = workshop.upload(Bytes(booked * decoder.ledger_bytes()));
  Bytes spins = image.spins;
  spins.resize(vectors(turning).size());
  w.spins = workshop.upload(spins);
  w.spin_rests = workshop.upload(vectors(turning));
  w.angular_accelerations = workshop.upload(vectors(turning));
  w.reported_spins = workshop.upload(spins);
  w.middles = options.holds_middles() ? workshop.upload(image.velocities) : workshop.upload(vectors(1));
  w.spin_middles = options.holds_middles() ? workshop.upload(spins) : workshop.upload(vectors(1));
  w.corrections = workshop.upload(vectors(options.corrects() ? correction_words * image.padded : 1));
  w.wall_tallies = workshop.upload(Bytes(booked_walls * decoder.wall_tally_bytes()));
  w.wall_sums = workshop.upload(Bytes(booked_walls * decoder.wall_sums_bytes()));
  const std::size_t lying = options.orientation != OrientationUpdate::none ? image.padded : 1;
  w.orientations = workshop.upload(repeated(image.as_drawn, lying));
  w.orientation_rests = workshop.upload(vectors(lying));
  w.springs = workshop.upload(memories(options.small ? remembering * remembering : 1));
  w.wall_springs = workshop.upload(memories(remembering * image.near.count()));
  w.faults = workshop.upload(bytes_of(std::vector<cl_int4>(image.padded, cl_int4{{never, 0, 0, 0}})));
  w.signals = workshop.upload(bytes_of(std::vector<cl_int>{never, never, never, 0}));
  return w;
}

}  // namespace grainproof::opencl
