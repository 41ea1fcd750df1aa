// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "app/first_difference.hpp"

#include <algorithm>
#include <bit>
#include <set>

#include "model/errors.hpp"

namespace grainproof::app {
namespace {

constexpr std::int64_t looks = 64;

bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

/// Collects who differs; the first found of the lowest id stands.
class Differences {
 public:
  explicit Differences(const State& state) { first_.step = state.step, first_.time = state.time; }

  void compare(std::int64_t particle, const std::string& what, double one, double other) {
    if (same_bits(one, other)) return;
    if (who_.empty() || particle < first_.particle) {
      first_.particle = particle;
      first_.what = what;
      first_.first = one;
      first_.second = other;
    }
    who_.insert(particle);
  }
  void compare(std::int64_t particle, const std::string& what, const Vec3& one, const Vec3& other) {
    for (int axis = 0; axis < 3; ++axis) compare(particle, what + " " + "xyz"[axis], one[axis], other[axis]);
  }
  std::optional<BitDifference> found() {
    if (who_.empty()) return {};
    first_.particles = static_cast<std::int64_t>(who_.size());
    return first_;
  }

 private:
  BitDifference first_;
  std::set<std::int64_t> who_;
};

void compare_contacts(Differences& differences, const State& one, const State& other) {
  const std::size_t both = std::min(one.contacts.size(), other.contacts.size());
  for (std::size_t k = 0; k < both; ++k) {
    const ContactMemory &a = one.contacts[k], &b = other.contacts[k];
    const std::string what = "contact with " + std::to_string(a.second) + ", ";
    differences.compare(a.first, what + "partner", static_cast<double>(a.second),
                        static_cast<double>(b.second));
    differences.compare(a.first, what + "displacement", a.tangential_displacement, b.tangential_displacement);
    differences.compare(a.first, what + "overlap", a.overlap, b.overlap);
    differences.compare(a.first, what + "rolling torque", a.rolling_torque, b.rolling_torque);
  }
  const auto& longer = one.contacts.size() > both ? one.contacts : other.contacts;
  for (std::size_t k = both; k < longer.size(); ++k)
    differences.compare(longer[k].first, "number of contacts", static_cast<double>(one.contacts.size()),
                        static_cast<double>(other.contacts.size()));
}

std::unique_ptr<Run> at_step(const Contestant& who, const std::optional<Checkpoint>& from,
                             std::int64_t step) {
  auto* restartable = dynamic_cast<RestartableEngine*>(&who.engine);
  std::unique_ptr<Run> run;
  if (restartable && from) {
    Resumed resumed = restartable->resume(who.scene, {}, *from);
    if (resumed.not_exact_because.empty()) run = std::move(resumed.run);
  }
  if (!run) run = who.engine.start(who.scene, {});
  run->advance(step - run->counters().steps);
  return run;
}

std::optional<Checkpoint> checkpoint_of(Run& run) {
  auto* restartable = dynamic_cast<RestartableRun*>(&run);
  if (restartable == nullptr) return {};
  return restartable->checkpoint();
}

/// Two runs that were the same at step `same`.
struct Pair {
  const Contestant& one;
  const Contestant& other;
  std::int64_t same = 0;
  std::optional<Checkpoint> first = {}, second = {};

  void agree_at(std::int64_t step, Run& a, Run& b) {
    same = step;
    first = checkpoint_of(a);
    second = checkpoint_of(b);
  }
};

BitDifference by_halves(Pair pair, BitDifference at) {
  while (at.step - pair.same > 1) {
    const std::int64_t middle = pair.same + (at.step - pair.same) / 2;
    const auto a = at_step(pair.one, pair.first, middle), b = at_step(pair.other, pair.second, middle);
    if (const auto found = bit_difference(a->state(), b->state()))
      at = *found;
    else
      pair.agree_at(middle, *a, *b);
  }
  return at;
}

}  // namespace

std::optional<BitDifference> bit_difference(const State& one, const State& other) {
  if (one.ids != other.ids)
    throw InputRefused("the two have other particles, so their bits cannot be compared");
  Differences differences(one);
  for (std::size_t i = 0; i < one.ids.size(); ++i) {
    differences.compare(one.ids[i], "position", one.position[i], other.position[i]);
    differences.compare(one.ids[i], "velocity", one.velocity[i], other.velocity[i]);
  }
  const std::size_t turning = std::min(one.angular_velocity.size(), other.angular_velocity.size());
  for (std::size_t i = 0; i < turning; ++i)
    differences.compare(one.ids[i], "angular velocity", one.angular_velocity[i], other.angular_velocity[i]);
  const std::size_t lying = std::min(one.orientation.size(), other.orientation.size());
  for (std::size_t i = 0; i < lying; ++i)
    for (int k = 0; k < 4; ++k)
      differences.compare(one.ids[i], std::string("orientation ") + "xyzw"[k], one.orientation[i].coeffs()[k],
                          other.orientation[i].coeffs()[k]);
  compare_contacts(differences, one, other);
  return differences.found();
}

std::optional<BitDifference> first_difference(const Contestant& one, const Contestant& other,
                                              std::int64_t last,
                                              const std::function<void(std::int64_t)>& progress) {
  const auto a = one.engine.start(one.scene, {}), b = other.engine.start(other.scene, {});
  if (const auto found = bit_difference(a->state(), b->state())) return found;
  Pair pair{one, other};
  while (pair.same < last) {
    const std::int64_t next = std::min(last, pair.same + std::max<std::int64_t>(last / looks, 1));
    a->advance(next - pair.same);
    b->advance(next - pair.same);
    if (const auto found = bit_difference(a->state(), b->state())) return by_halves(std::move(pair), *found);
    pair.agree_at(next, *a, *b);
    progress(next);
  }
  return {};
}

}  // namespace grainproof::app
