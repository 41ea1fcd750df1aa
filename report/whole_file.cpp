// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/whole_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <vector>

#include "model/errors.hpp"

namespace grainproof::report {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void fail(const std::string& what, const fs::path& path) {
  throw fs::filesystem_error(what, path, std::error_code(errno, std::generic_category()));
}

/// Until it is on the disk.
void put_on_disk(const fs::path& path, int flags) {
  const int file = open(path.c_str(), flags);
  if (file < 0) fail("cannot open", path);
  const int status = fsync(file);
  const int reason = errno;
  close(file);
  errno = reason;
  if (status != 0) fail("cannot write", path);
}

/// FNV-1a over eight bytes at a time; the rest is filled up with zeros.
std::uint64_t hash_of_rest(std::ifstream& file) {
  std::uint64_t hash = 0xcbf29ce484222325ull;
  std::vector<char> chunk(1 << 20);
  while (file) {
    file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    const auto read = static_cast<std::size_t>(file.gcount());
    std::fill(chunk.begin() + static_cast<std::ptrdiff_t>(read), chunk.end(), '\0');
    for (std::size_t i = 0; i < read; i += 8) {
      std::uint64_t word;
      std::memcpy(&word, chunk.data() + i, 8);
      hash = (hash ^ word) * 0x100000001b3ull;
      hash ^= hash >> 29;
    }
  }
  return hash;
}

struct Seal {
  std::string kind;
  int layout = 0;
  std::uintmax_t bytes = 0;
  std::uint64_t hash = 0;

  std::string text() const {
    std::ostringstream line;
    line << kind << " layout " << layout << " bytes " << bytes << " hash " << std::hex << hash << "\n";
    return line.str();
  }
};

std::uint64_t content_hash(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(seal_bytes);
  return hash_of_rest(file);
}

}  // namespace

void write_sealed(const fs::path& path, const std::string& kind, int layout,
                  const std::function<void(const fs::path&)>& fill) {
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  const fs::path part = path.string() + ".part";
  fill(part);
  std::string text = Seal{kind, layout, fs::file_size(part), content_hash(part)}.text();
  text.resize(seal_bytes, '\0');
  std::fstream file(part, std::ios::binary | std::ios::in | std::ios::out);
  file.write(text.data(), seal_bytes);
  file.close();
  if (!file) fail("cannot write", part);
  put_on_disk(part, O_RDWR);
  fs::rename(part, path);
  put_on_disk(path.has_parent_path() ? path.parent_path() : fs::path("."), O_RDONLY | O_DIRECTORY);
}

void require_sealed(const fs::path& path, const std::string& kind, int layout) {
  const std::string name = path.string();
  if (!fs::is_regular_file(path)) throw InputRefused(name + " is not there, or no file");
  std::ifstream file(path, std::ios::binary);
  std::array<char, seal_bytes + 1> front{};
  file.read(front.data(), seal_bytes);
  const std::string text(front.data());
  if (text.compare(0, kind.size() + 8, kind + " layout ") != 0)
    throw InputRefused(name + " is not a " + kind);
  Seal seal{kind};
  std::string word;
  std::istringstream line(text.substr(kind.size()));
  line >> word >> seal.layout >> word >> seal.bytes >> word >> std::hex >> seal.hash;
  if (seal.layout != layout)
    throw InputRefused(name + " is a " + kind + " of layout " + std::to_string(seal.layout) +
                       "; this program reads layout " + std::to_string(layout));
  if (!line || static_cast<std::size_t>(file.gcount()) < seal_bytes || fs::file_size(path) != seal.bytes)
    throw InputRefused(name + " has " + std::to_string(fs::file_size(path)) + " bytes instead of " +
                       std::to_string(seal.bytes) + ": it is truncated, or was changed");
  if (hash_of_rest(file) != seal.hash)
    throw InputRefused(name + " is damaged: its content is not what was written");
}

}  // namespace grainproof::report
