// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "opencl/bytes.hpp"
#include "opencl/coordinates.hpp"

namespace grainproof::opencl {
namespace {

template <class P>
class DecoderOf : public Decoder {
 public:
  explicit DecoderOf(const Domain& domain) : coordinates_(domain), domain_(domain) {}

  Vec3 position(std::span<const std::byte> positions, std::size_t i) const override {
    return inside(coordinates_.metres(value_at<typename P::Position>(positions, i)));
  }
  Vec3 vector(std::span<const std::byte> vectors, std::size_t i) const override {
    const auto v = value_at<typename P::Real4>(vectors, i);
    return {v.s[0], v.s[1], v.s[2]};
  }
  Quaternion quaternion(std::span<const std::byte> vectors, std::size_t i) const override {
    const auto q = value_at<typename P::Real4>(vectors, i);
    return Quaternion(q.s[3], q.s[0], q.s[1], q.s[2]);
  }
  void put(std::span<std::byte> vectors, std::size_t i, const Vec3& vector, double fourth) const override {
    const auto four = four_of<P>(vector, fourth);
    std::memcpy(vectors.data() + i * sizeof(four), &four, sizeof(four));
  }
  double fourth(std::span<const std::byte> vectors, std::size_t i) const override {
    return value_at<typename P::Real4>(vectors, i).s[3];
  }
  std::size_t position_bytes() const override { return sizeof(typename P::Position); }
  std::size_t vector_bytes() const override { return sizeof(typename P::Real4); }
  std::size_t reach_bytes() const override { return sizeof(typename P::Reach); }
  std::size_t tally_bytes() const override { return sizeof(Tally<P>); }
  std::size_t ledger_bytes() const override { return sizeof(LedgerSums<P>); }
  std::size_t wall_tally_bytes() const override { return sizeof(WallTally<P>); }
  std::size_t wall_sums_bytes() const override { return sizeof(WallSums<P>); }

 private:
  /// A part of a quantum, or a rounding, may lie across a periodic face.
  Vec3 inside(Vec3 x) const {
    for (int axis = 0; axis < 3; ++axis) {
      if (!domain_.periodic(axis)) continue;
      if (x[axis] < domain_.lower[axis])
        x[axis] = std::min(x[axis] + domain_.extent()[axis], domain_.upper[axis]);
      if (x[axis] >= domain_.upper[axis])
        x[axis] = std::max(x[axis] - domain_.extent()[axis], domain_.lower[axis]);
    }
    return x;
  }

  Coordinates<P> coordinates_;
  Domain domain_;
};

}  // namespace

std::unique_ptr<Decoder> make_decoder(Precision precision, const Domain& domain) {
  return with_types_of(precision, [&](auto types) -> std::unique_ptr<Decoder> {
    return std::make_unique<DecoderOf<decltype(types)>>(domain);
  });
}

}  // namespace grainproof::opencl
