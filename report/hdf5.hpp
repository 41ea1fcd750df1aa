// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// As much of HDF5 as a checkpoint needs: named arrays in groups, and attributes. Groups are made on the way.
namespace grainproof::report::hdf5 {

class Failed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An identifier of the library and how it is given back.
class Handle {
 public:
  using Close = int (*)(std::int64_t);
  Handle(std::int64_t id, Close close, const std::string& what);
  ~Handle();
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  std::int64_t id() const { return id_; }

 private:
  std::int64_t id_;
  Close close_;
};

/// An open file. Everything throws Failed.
class File {
 public:
  /// Made anew, with room for `user_block` bytes of the caller's own in front.
  static File made(const std::filesystem::path& path, std::size_t user_block);
  static File opened(const std::filesystem::path& path);

  /// Rows of `columns` values; one column is a plain array.
  void put(const std::string& name, const std::vector<double>& values, std::size_t columns = 1);
  void put(const std::string& name, const std::vector<std::int64_t>& values);
  void put(const std::string& name, const std::vector<std::byte>& values);
  void get(const std::string& name, std::vector<double>& values) const;
  void get(const std::string& name, std::vector<std::int64_t>& values) const;
  void get(const std::string& name, std::vector<std::byte>& values) const;
  bool has(const std::string& name) const;
  /// Names of what a group holds, sorted.
  std::vector<std::string> names_in(const std::string& group) const;

  void make_group(const std::string& name);
  /// Of a group; "/" is the file's own.
  void put_attribute(const std::string& group, const std::string& name, const std::string& value);
  void put_attribute(const std::string& group, const std::string& name, std::int64_t value);
  void put_attribute(const std::string& group, const std::string& name, double value);
  std::string text_attribute(const std::string& group, const std::string& name) const;
  std::int64_t integer_attribute(const std::string& group, const std::string& name) const;
  double number_attribute(const std::string& group, const std::string& name) const;

 private:
  explicit File(Handle file) : file_(std::move(file)) {}
  Handle file_;
};

}  // namespace grainproof::report::hdf5
