// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/hdf5.hpp"

#include <hdf5.h>

#include <array>

namespace grainproof::report::hdf5 {
namespace {

static_assert(sizeof(hid_t) == sizeof(std::int64_t));

void require(herr_t status, const std::string& what) {
  if (status < 0) throw Failed("HDF5 cannot " + what);
}

Handle property_list(hid_t kind) {
  return {H5Pcreate(kind), H5Pclose, "make a property list"};
}

Handle space_of(std::size_t values, std::size_t columns) {
  const std::array<hsize_t, 2> sizes{values / columns, columns};
  return {H5Screate_simple(columns > 1 ? 2 : 1, sizes.data(), nullptr), H5Sclose, "make a data space"};
}

hid_t type_of(double) {
  return H5T_NATIVE_DOUBLE;
}
hid_t type_of(std::int64_t) {
  return H5T_NATIVE_INT64;
}
hid_t type_of(std::byte) {
  return H5T_NATIVE_UINT8;
}

template <class Value>
void put_values(hid_t file, const std::string& name, const std::vector<Value>& values, std::size_t columns) {
  const Handle links = property_list(H5P_LINK_CREATE);
  require(H5Pset_create_intermediate_group(links.id(), 1), "make groups on the way");
  const Handle space = space_of(values.size(), columns);
  const Handle set(
      H5Dcreate2(file, name.c_str(), type_of(Value{}), space.id(), links.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose, "make " + name);
  if (values.empty()) return;
  require(H5Dwrite(set.id(), type_of(Value{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          "write " + name);
}

template <class Value>
void get_values(hid_t file, const std::string& name, std::vector<Value>& values) {
  const Handle set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, "find " + name);
  const Handle space(H5Dget_space(set.id()), H5Sclose, "measure " + name);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (count < 0) throw Failed("HDF5 cannot measure " + name);
  values.resize(static_cast<std::size_t>(count));
  if (values.empty()) return;
  require(H5Dread(set.id(), type_of(Value{}), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read " + name);
}

Handle text_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a text");
  require(H5Tset_size(type.id(), length + 1), "make a text");
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8), "make a text");
  return type;
}

void put_value(hid_t file, const std::string& group, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "make a data space");
  const Handle attribute(H5Acreate_by_name(file, group.c_str(), name.c_str(), type, space.id(), H5P_DEFAULT,
                                           H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose, "make the attribute " + name);
  require(H5Awrite(attribute.id(), type, value), "write the attribute " + name);
}

Handle attribute_of(hid_t file, const std::string& group, const std::string& name) {
  return {H5Aopen_by_name(file, group.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
          "find the attribute " + name};
}

template <class Value>
Value value_of(hid_t file, const std::string& group, const std::string& name) {
  const Handle attribute = attribute_of(file, group, name);
  Value value{};
  require(H5Aread(attribute.id(), type_of(value), &value), "read the attribute " + name);
  return value;
}

/// The library prints what it fails at; here it is an exception's business.
void be_silent() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

}  // namespace

Handle::Handle(std::int64_t id, Close close, const std::string& what) : id_(id), close_(close) {
  if (id_ < 0) throw Failed("HDF5 cannot " + what);
}

Handle::~Handle() {
  if (id_ >= 0) close_(id_);
}

File File::made(const std::filesystem::path& path, std::size_t user_block) {
  be_silent();
  const Handle creation = property_list(H5P_FILE_CREATE);
  require(H5Pset_userblock(creation.id(), user_block), "leave room in front");
  return File({H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), H5P_DEFAULT), H5Fclose,
               "make " + path.string()});
}

File File::opened(const std::filesystem::path& path) {
  be_silent();
  return File({H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open " + path.string()});
}

void File::put(const std::string& name, const std::vector<double>& values, std::size_t columns) {
  put_values(file_.id(), name, values, columns);
}
void File::put(const std::string& name, const std::vector<std::int64_t>& values) {
  put_values(file_.id(), name, values, 1);
}
void File::put(const std::string& name, const std::vector<std::byte>& values) {
  put_values(file_.id(), name, values, 1);
}
void File::get(const std::string& name, std::vector<double>& values) const {
  get_values(file_.id(), name, values);
}
void File::get(const std::string& name, std::vector<std::int64_t>& values) const {
  get_values(file_.id(), name, values);
}
void File::get(const std::string& name, std::vector<std::byte>& values) const {
  get_values(file_.id(), name, values);
}

bool File::has(const std::string& name) const {
  return H5Lexists(file_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> File::names_in(const std::string& group) const {
  const Handle opened(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT), H5Gclose, "find " + group);
  H5G_info_t info{};
  require(H5Gget_info(opened.id(), &info), "look into " + group);
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    std::array<char, 256> name{};
    if (H5Lget_name_by_idx(opened.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(),
                           H5P_DEFAULT) < 0)
      throw Failed("HDF5 cannot look into " + group);
    names.emplace_back(name.data());
  }
  return names;
}

void File::make_group(const std::string& name) {
  const Handle group(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                     "make " + name);
}

void File::put_attribute(const std::string& group, const std::string& name, const std::string& value) {
  put_value(file_.id(), group, name, text_type(value.size()).id(), value.c_str());
}
void File::put_attribute(const std::string& group, const std::string& name, std::int64_t value) {
  put_value(file_.id(), group, name, type_of(value), &value);
}
void File::put_attribute(const std::string& group, const std::string& name, double value) {
  put_value(file_.id(), group, name, type_of(value), &value);
}

std::string File::text_attribute(const std::string& group, const std::string& name) const {
  const Handle attribute = attribute_of(file_.id(), group, name);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose, "read the attribute " + name);
  std::vector<char> text(H5Tget_size(type.id()) + 1);
  require(H5Aread(attribute.id(), type.id(), text.data()), "read the attribute " + name);
  return text.data();
}
std::int64_t File::integer_attribute(const std::string& group, const std::string& name) const {
  return value_of<std::int64_t>(file_.id(), group, name);
}
double File::number_attribute(const std::string& group, const std::string& name) const {
  return value_of<double>(file_.id(), group, name);
}

}  // namespace grainproof::report::hdf5
