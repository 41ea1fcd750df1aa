// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/scene_identity.hpp"

#include <bit>

#include "comparisons/external/scene_json.hpp"

namespace grainproof::app {
namespace {

class Hash {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x100000001b3ull;
    value_ ^= value_ >> 29;
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  void add(const Vec3& vector) {
    for (const double component : vector) add(component);
  }
  void add(const std::string& text) {
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

std::uint64_t hash_of(const std::vector<Particle>& particles) {
  Hash hash;
  for (const Particle& p : particles) {
    for (const std::int64_t number : {p.id, std::int64_t{p.material}, std::int64_t{p.fixed}})
      hash.add(static_cast<std::uint64_t>(number));
    hash.add(p.diameter);
    hash.add(p.effect_diameter);
    for (const Vec3& vector : {p.position, p.velocity, p.angular_velocity}) hash.add(vector);
  }
  return hash.value();
}

std::uint64_t hash_of(const std::vector<ContactMemory>& memories) {
  Hash hash;
  for (const ContactMemory& memory : memories) {
    hash.add(static_cast<std::uint64_t>(memory.first));
    hash.add(static_cast<std::uint64_t>(memory.second));
    hash.add(memory.tangential_displacement);
    hash.add(memory.overlap);
    hash.add(memory.rolling_torque);
  }
  return hash.value();
}

/// What the JSON of a scene leaves to the engines.
std::uint64_t hash_of(const RunSettings& run, OrientationUpdate orientation) {
  Hash hash;
  for (const int choice :
       {static_cast<int>(run.order), static_cast<int>(run.neighbours), static_cast<int>(orientation)})
    hash.add(static_cast<std::uint64_t>(choice));
  hash.add(run.skin);
  return hash.value();
}

}  // namespace

report::Fingerprints fingerprints_of(const Scene& scene) {
  report::Fingerprints parts;
  Scene bare = scene;
  bare.particles.clear();
  bare.remembered.clear();
  bare.title.clear();
  bare.run.end = 0.0;
  bare.run.sample_times = {0.0};
  const nlohmann::json json = external::scene_json(bare, {});
  for (const auto& [part, value] : json.items()) {
    Hash hash;
    hash.add(value.dump());
    parts[part] = hash.value();
  }
  parts["particles"] = hash_of(scene.particles);
  parts["remembered"] = hash_of(scene.remembered);
  parts["order, neighbours, skin"] = hash_of(scene.run, scene.orientation);
  return parts;
}

}  // namespace grainproof::app
