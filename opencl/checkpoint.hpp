// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "model/checkpoint.hpp"
#include "opencl/workshop.hpp"

namespace grainproof::opencl {

/// A run that can take over what another of its kind has put into a checkpoint's own part.
class RestorableRun : public RestartableRun {
 public:
  /// Who can read the own part: precision and path.
  virtual std::string maker() const = 0;
  /// Goes on with the same bits. Throws InputRefused, and is of no use any more, where the part is of a run
  /// with other buffers.
  virtual void restore(const Sections& own) = 0;
  /// To be told before the first step.
  virtual void begin_at(const Beginning& beginning) = 0;
};

/// The first `bytes` of a buffer, by default all of it.
void pack_buffer(Sections& own, const std::string& name, Workshop& workshop, const cl::Buffer& buffer);
void pack_buffer(Sections& own, const std::string& name, Workshop& workshop, const cl::Buffer& buffer,
                 std::size_t bytes);

/// Into a buffer of the same size. Throws InputRefused where it has another.
void unpack_buffer(const Sections& own, const std::string& name, Workshop& workshop, cl::Buffer& buffer);

/// A new buffer of the size of the section; never empty.
cl::Buffer unpacked_buffer(const Sections& own, const std::string& name, Workshop& workshop);

}  // namespace grainproof::opencl
