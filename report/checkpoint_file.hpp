// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "model/checkpoint.hpp"

namespace grainproof::report {

/// A scene by its parts: "particles", "walls", … and a hash of each.
using Fingerprints = std::map<std::string, std::uint64_t>;

/// What a checkpoint's file tells besides the run.
struct CheckpointOrigin {
  std::string scene;  ///< name of the case
  Fingerprints parts;
  Provenance provenance;
};

struct SavedCheckpoint {
  CheckpointOrigin origin;
  Checkpoint checkpoint;
};

/// docs/results.md. The file is there as a whole or not at all, whenever the program is killed: what was
/// there before stays until the new one is on the disk. Throws std::filesystem::filesystem_error.
void write_checkpoint(const std::filesystem::path& path, const SavedCheckpoint& saved);

/// Throws InputRefused for a file that is not there, foreign, of another layout, truncated or damaged.
SavedCheckpoint read_checkpoint(const std::filesystem::path& path);

/// Throws InputRefused, saying in which parts they differ, unless the checkpoint is of this scene.
void require_same_scene(const std::filesystem::path& path, const CheckpointOrigin& origin,
                        const std::string& scene, const Fingerprints& parts);

}  // namespace grainproof::report
