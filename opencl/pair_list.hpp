// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "model/sections.hpp"
#include "opencl/scan.hpp"
#include "opencl/world.hpp"

namespace grainproof::opencl {

/// Zones and the list of partners built from them, all on the device.
class PairList {
 public:
  PairList(Workshop& workshop, Program& program, const SceneImage& image, const Decoder& decoder,
           const ZoneGrid& grid, std::size_t work_group, std::size_t memory_bytes = 0);

  /// For the positions that `world` has now. Waits once, for the number of pairs. Where an entry has a
  /// memory, those of the list before are carried over.
  void build(const World& world);

  const cl::Buffer& starts() const { return now_.starts; }
  const cl::Buffer& partners() const { return now_.partners; }
  /// `memory_bytes` an entry; not there where that is 0.
  cl::Buffer& springs() { return now_.springs; }
  const cl::Buffer& springs() const { return now_.springs; }
  const cl::Buffer& built_at() const { return built_at_; }
  /// Entries of the list: a pair of moving particles has two.
  std::int64_t entries() const { return entries_; }

  void pack_into(Sections& own) const;
  void unpack_from(const Sections& own);

 private:
  struct Entries {
    cl::Buffer starts, partners, springs;
    std::int64_t room = 0;
  };

  void fill_zones(const World& world);
  void make_room(std::int64_t entries);

  Workshop& workshop_;
  Program& program_;
  std::size_t particles_;
  std::size_t padded_;
  std::size_t zones_;
  std::size_t work_group_;
  Scan scan_;
  cl::Buffer zone_counts_, zone_starts_, zone_of_particle_, members_;
  cl::Buffer pair_counts_, built_at_;
  std::size_t memory_bytes_;
  Entries now_, before_;  ///< the second only where entries have a memory
  std::int64_t entries_ = 0;
};

}  // namespace grainproof::opencl
