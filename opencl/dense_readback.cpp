// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>

#include "model/errors.hpp"
#include "opencl/bytes.hpp"
#include "opencl/dense_run.hpp"
#include "opencl/layout.hpp"
#include "opencl/near_walls.hpp"

namespace grainproof::opencl {
namespace {

/// FNV-1a over eight bytes at a time.
std::uint64_t hashed(std::uint64_t hash, const void* data, std::size_t bytes) {
  for (std::size_t i = 0; i + 8 <= bytes; i += 8) {
    std::uint64_t word;
    std::memcpy(&word, static_cast<const std::byte*>(data) + i, 8);
    hash = (hash ^ word) * 0x100000001b3ull;
    hash ^= hash >> 29;
  }
  return hash;
}

/// The springs and who has one, as the device has written them down: a row of lanes for each entry that
/// touches.
struct SpringRows {
  Bytes springs;
  std::vector<cl_int> marks;
  std::size_t group, lanes, words;  ///< bodies of a group, of a mark, and numbers a mark
  bool in_double;

  /// Zero where the body in this lane has none in this slot of the list.
  Vec3 at(std::size_t slot, std::size_t lane) const {
    const std::size_t spans = group / lanes;
    const cl_int mark = marks[(slot * spans + lane / lanes) * words];
    if ((mark & 1) == 0) return Vec3::Zero();
    const std::size_t row = static_cast<std::size_t>(mark) / 2 - 1;
    Vec3 spring;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t place = (3 * (row / spans) + axis) * group + row % spans * lanes + lane % lanes;
      spring[static_cast<Eigen::Index>(axis)] =
          in_double ? value_at<cl_double>(springs, place) : value_at<cl_float>(springs, place);
    }
    return spring;
  }
};

/// The walls, by index, that the first slots of a group are about.
std::vector<std::int64_t> walls_of(const cl_int4& head, const NearWalls& near) {
  std::vector<std::int64_t> walls;
  for (std::size_t k = 0; k < near.planes.size(); ++k)
    if (head.s[2] >> k & 1) walls.push_back(near.planes[k].index);
  return walls;
}

/// A spring is told where it is strained, once for both bodies: the device keeps it for each, as the
/// displacement of the body relative to its partner.
std::vector<ContactMemory> strained(const Scene& scene, const DenseLists& lists, const SpringRows& rows) {
  const NearWalls near = near_walls(scene);
  std::vector<ContactMemory> found;
  for (std::size_t g = 0; g < lists.heads.size(); ++g) {
    const std::vector<std::int64_t> walls = walls_of(lists.heads[g], near);
    for (std::size_t k = 0; k < static_cast<std::size_t>(lists.heads[g].s[1]); ++k) {
      const std::size_t slot = static_cast<std::size_t>(lists.heads[g].s[0]) + k;
      for (std::size_t lane = 0; lane < rows.group; ++lane) {
        const Vec3 spring = rows.at(slot, lane);
        if (spring.isZero(0.0)) continue;
        const auto self = static_cast<std::size_t>(lists.ids[g * rows.group + lane]);
        if (k < walls.size()) {
          found.push_back({scene.particles[self].id, -1 - walls[k], 0, spring});
          continue;
        }
        const auto entry = static_cast<std::size_t>(lists.entries[slot * rows.group + lane]);
        const auto other = static_cast<std::size_t>(lists.ids[entry]);
        if (self < other) found.push_back({scene.particles[self].id, scene.particles[other].id, 0, -spring});
      }
    }
  }
  return found;
}

}  // namespace

const cl::Buffer& DenseRun::report(const cl::Buffer& springs, const cl::Buffer& marks, bool keeps) {
  const auto at = static_cast<std::size_t>(done_ & 1);
  workshop_->launch(*program_, "dense_report", items_, world_.box, world_.laws, world_.planes,
                    world_.records[at], world_.kept, world_.built_at, world_.cells, world_.heads, world_.list,
                    world_.springs, springs, world_.marks, marks, world_.records[1 - at], signals_,
                    static_cast<cl_int>(done_), static_cast<cl_int>(keeps));
  return world_.records[1 - at];
}

DenseRecords DenseRun::read_records(const cl::Buffer& records) {
  const std::size_t real = options_.precision == Precision::double_precision ? 8 : 4;
  const auto kept = static_cast<std::size_t>(kept_numbers(options_.precision));
  const auto quarters = static_cast<std::size_t>(quarters_of(options_));
  DenseRecords r;
  r.records.resize(image_.padded * quarters * 4 * real);
  r.kept.resize(image_.padded * kept * real);
  r.built_at.resize(image_.padded * 3 * real);
  r.cells.resize(image_.padded * sizeof(cl_int));
  r.ids.resize(image_.padded);
  workshop_->read_later(records, r.records);
  if (kept > 0) workshop_->read_later(world_.kept, r.kept);
  workshop_->read_later(world_.built_at, r.built_at);
  workshop_->read_later(world_.cells, r.cells);
  workshop_->read(world_.ids, std::as_writable_bytes(std::span(r.ids)));
  return r;
}

std::vector<DenseBody> DenseRun::bodies(const cl::Buffer& records) {
  const DenseRecords read = read_records(records);
  std::vector<DenseBody> all(image_.particles);
  for (std::size_t i = 0; i < image_.particles; ++i)
    all[static_cast<std::size_t>(read.ids[i])] = decoded(read, i, options_, grid_);
  return all;
}

Frame DenseRun::frame() {
  synchronise();
  Frame frame;
  frame.step = first_step_ + done_;
  frame.time = static_cast<double>(frame.step) * scene_.run.step;
  for (const DenseBody& body : bodies(report(world_.springs, world_.marks, false))) {
    frame.position.push_back(body.position);
    frame.velocity.push_back(body.velocity);
    if (scene_.rotation) frame.angular_velocity.push_back(body.spin);
  }
  return frame;
}

State DenseRun::state() {
  const bool lags = scene_.run.integrator == Integrator::leapfrog_verlet && done_ > 0;
  Frame now = frame();
  State state;
  state.step = now.step;
  state.time = now.time;
  for (const Particle& p : scene_.particles) state.ids.push_back(p.id);
  state.position = std::move(now.position);
  state.velocity = std::move(now.velocity);
  state.angular_velocity = std::move(now.angular_velocity);
  state.velocity_lag = lags ? 0.5 : 0.0;
  if (lags) {
    const auto held = bodies(world_.records[static_cast<std::size_t>(done_ & 1)]);
    for (std::size_t i = 0; i < held.size(); ++i) {
      state.velocity[i] = held[i].velocity;
      if (scene_.rotation) state.angular_velocity[i] = held[i].spin;
    }
  }
  state.contacts = memories();
  return state;
}

std::uint64_t DenseRun::digest() {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  synchronise();
  for (const DenseBody& body : bodies(world_.records[static_cast<std::size_t>(done_ & 1)])) {
    hash = hashed(hash, &body, sizeof(body));
  }
  for (const ContactMemory& memory : memories()) {
    const std::array words{memory.first, memory.second};
    hash = hashed(hash, words.data(), sizeof(words));
    hash = hashed(hash, memory.tangential_displacement.data(), sizeof(Vec3));
  }
  return hash;
}

DenseLists DenseRun::read_lists() {
  DenseLists l;
  l.heads.resize(image_.padded / group());
  l.entries.resize(static_cast<std::size_t>(list_.slots()) * group());
  l.ids.resize(image_.padded);
  workshop_->read(world_.heads, std::as_writable_bytes(std::span(l.heads)));
  if (!l.entries.empty()) workshop_->read(world_.list, std::as_writable_bytes(std::span(l.entries)));
  for (cl_int& entry : l.entries) entry /= units_a_record(options_);
  workshop_->read(world_.ids, std::as_writable_bytes(std::span(l.ids)));
  return l;
}

// By first and second.
std::vector<ContactMemory> DenseRun::memories() {
  if (!options_.history || list_.slots() == 0) return {};
  SpringRows rows{Bytes(list_.springs_bytes()),
                  {},
                  group(),
                  static_cast<std::size_t>(lanes_of(options_)),
                  mark_words(options_),
                  options_.precision == Precision::double_precision};
  rows.marks.resize(static_cast<std::size_t>(list_.slots()) * (rows.group / rows.lanes) * rows.words);
  const cl::Buffer on_device = workshop_->room(rows.springs.size());
  const cl::Buffer marked = workshop_->upload(bytes_of(rows.marks));
  // Whoever only looks takes no rows.
  const DenseSignals signals = read_signals();
  report(on_device, marked, true);
  workshop_->write(signals_, std::as_bytes(std::span(&signals, 1)));
  workshop_->read(on_device, rows.springs);
  workshop_->read(marked, std::as_writable_bytes(std::span(rows.marks)));
  std::vector<ContactMemory> found = strained(scene_, read_lists(), rows);
  std::sort(found.begin(), found.end(), [](const ContactMemory& a, const ContactMemory& b) {
    return std::tie(a.first, a.second) < std::tie(b.first, b.second);
  });
  return found;
}

}  // namespace grainproof::opencl
