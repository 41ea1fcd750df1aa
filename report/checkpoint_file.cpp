// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/checkpoint_file.hpp"

#include <algorithm>

#include "model/errors.hpp"
#include "model/ledger_numbers.hpp"
#include "report/hdf5.hpp"
#include "report/whole_file.hpp"

namespace grainproof::report {
namespace {

constexpr const char* kind = "grainproof checkpoint";
constexpr int layout = 1;

std::vector<double> rows(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vec3& v : vectors) numbers.insert(numbers.end(), v.data(), v.data() + 3);
  return numbers;
}

std::vector<Vec3> vectors_in(const hdf5::File& file, const std::string& name) {
  std::vector<double> numbers;
  file.get(name, numbers);
  std::vector<Vec3> vectors;
  for (std::size_t i = 0; i + 3 <= numbers.size(); i += 3) vectors.emplace_back(numbers.data() + i);
  return vectors;
}

/// The scalar first, as frames have it.
std::vector<double> rows(const std::vector<Quaternion>& orientations) {
  std::vector<double> numbers;
  for (const Quaternion& q : orientations)
    for (const double component : {q.w(), q.x(), q.y(), q.z()}) numbers.push_back(component);
  return numbers;
}

std::vector<Quaternion> orientations_in(const hdf5::File& file, const std::string& name) {
  std::vector<double> n;
  file.get(name, n);
  std::vector<Quaternion> orientations;
  for (std::size_t i = 0; i + 4 <= n.size(); i += 4)
    orientations.emplace_back(n[i], n[i + 1], n[i + 2], n[i + 3]);
  return orientations;
}

template <class Value, class Member>
std::vector<Value> column(const std::vector<ContactMemory>& contacts, Member member) {
  std::vector<Value> values;
  for (const ContactMemory& contact : contacts) values.push_back(contact.*member);
  return values;
}

void put_contacts(hdf5::File& file, const std::vector<ContactMemory>& contacts) {
  const std::string in = "/state/contacts/";
  file.put(in + "first", column<std::int64_t>(contacts, &ContactMemory::first));
  file.put(in + "second", column<std::int64_t>(contacts, &ContactMemory::second));
  file.put(in + "feature", column<std::int64_t>(contacts, &ContactMemory::feature));
  file.put(in + "overlap", column<double>(contacts, &ContactMemory::overlap));
  file.put(in + "tangential_displacement",
           rows(column<Vec3>(contacts, &ContactMemory::tangential_displacement)), 3);
  file.put(in + "rolling_torque", rows(column<Vec3>(contacts, &ContactMemory::rolling_torque)), 3);
}

std::vector<ContactMemory> contacts_in(const hdf5::File& file) {
  const std::string in = "/state/contacts/";
  std::vector<std::int64_t> first, second, feature;
  std::vector<double> overlap;
  file.get(in + "first", first);
  file.get(in + "second", second);
  file.get(in + "feature", feature);
  file.get(in + "overlap", overlap);
  const auto displacement = vectors_in(file, in + "tangential_displacement");
  const auto torque = vectors_in(file, in + "rolling_torque");
  const std::size_t least =
      std::min({second.size(), feature.size(), overlap.size(), displacement.size(), torque.size()});
  if (least < first.size()) throw hdf5::Failed("a column of /state/contacts is too short");
  std::vector<ContactMemory> contacts;
  for (std::size_t i = 0; i < first.size(); ++i)
    contacts.push_back(
        {first[i], second[i], static_cast<std::int32_t>(feature[i]), displacement[i], overlap[i], torque[i]});
  return contacts;
}

void put_state(hdf5::File& file, const State& state) {
  file.make_group("/state");
  file.put_attribute("/state", "step", state.step);
  file.put_attribute("/state", "time", state.time);
  file.put_attribute("/state", "velocity_lag", state.velocity_lag);
  file.put("/state/ids", state.ids);
  file.put("/state/position", rows(state.position), 3);
  file.put("/state/velocity", rows(state.velocity), 3);
  file.put("/state/angular_velocity", rows(state.angular_velocity), 3);
  file.put("/state/orientation", rows(state.orientation), 4);
  put_contacts(file, state.contacts);
}

State state_in(const hdf5::File& file) {
  State state;
  state.step = file.integer_attribute("/state", "step");
  state.time = file.number_attribute("/state", "time");
  state.velocity_lag = file.number_attribute("/state", "velocity_lag");
  file.get("/state/ids", state.ids);
  state.position = vectors_in(file, "/state/position");
  state.velocity = vectors_in(file, "/state/velocity");
  state.angular_velocity = vectors_in(file, "/state/angular_velocity");
  state.orientation = orientations_in(file, "/state/orientation");
  state.contacts = contacts_in(file);
  return state;
}

void put_origin(hdf5::File& file, const CheckpointOrigin& origin) {
  file.put_attribute("/", "format", std::string(kind));
  file.put_attribute("/", "layout", std::int64_t{layout});
  file.put_attribute("/", "grainproof", std::string(GRAINPROOF_VERSION));
  file.put_attribute("/", "engine", origin.provenance.engine);
  file.put_attribute("/", "precision", origin.provenance.precision);
  file.put_attribute("/", "device", origin.provenance.device);
  file.make_group("/scene");
  file.put_attribute("/scene", "name", origin.scene);
  for (const auto& [part, hash] : origin.parts) {
    file.make_group("/scene/" + part);
    file.put_attribute("/scene/" + part, "hash", static_cast<std::int64_t>(hash));
  }
}

CheckpointOrigin origin_in(const hdf5::File& file) {
  CheckpointOrigin origin;
  origin.scene = file.text_attribute("/scene", "name");
  origin.provenance.engine = file.text_attribute("/", "engine");
  origin.provenance.precision = file.text_attribute("/", "precision");
  origin.provenance.device = file.text_attribute("/", "device");
  for (const std::string& part : file.names_in("/scene"))
    origin.parts[part] = static_cast<std::uint64_t>(file.integer_attribute("/scene/" + part, "hash"));
  return origin;
}

void put_own(hdf5::File& file, const Checkpoint& checkpoint) {
  file.make_group("/engine");
  file.put_attribute("/engine", "maker", checkpoint.maker);
  for (const auto& [name, bytes] : checkpoint.own) file.put("/engine/" + name, bytes);
}

Checkpoint checkpoint_in(const hdf5::File& file) {
  Checkpoint checkpoint{.state = state_in(file)};
  std::vector<double> ledger;
  if (file.has("/ledger")) file.get("/ledger", ledger);
  if (!ledger.empty()) checkpoint.ledger = ledger_of(ledger);
  checkpoint.maker = file.text_attribute("/engine", "maker");
  for (const std::string& name : file.names_in("/engine")) file.get("/engine/" + name, checkpoint.own[name]);
  return checkpoint;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const SavedCheckpoint& saved) {
  try {
    write_sealed(path, kind, layout, [&](const std::filesystem::path& part) {
      hdf5::File file = hdf5::File::made(part, seal_bytes);
      put_origin(file, saved.origin);
      put_state(file, saved.checkpoint.state);
      if (saved.checkpoint.ledger) file.put("/ledger", numbers_of(*saved.checkpoint.ledger));
      put_own(file, saved.checkpoint);
    });
  } catch (const hdf5::Failed& failed) {
    throw std::filesystem::filesystem_error(failed.what(), path, std::make_error_code(std::errc::io_error));
  }
}

SavedCheckpoint read_checkpoint(const std::filesystem::path& path) {
  require_sealed(path, kind, layout);
  try {
    const hdf5::File file = hdf5::File::opened(path);
    return {origin_in(file), checkpoint_in(file)};
  } catch (const hdf5::Failed& failed) {
    throw InputRefused(path.string() + " is damaged: " + failed.what());
  }
}

void require_same_scene(const std::filesystem::path& path, const CheckpointOrigin& origin,
                        const std::string& scene, const Fingerprints& parts) {
  std::string differing;
  for (const auto& [part, hash] : parts) {
    const auto found = origin.parts.find(part);
    if (found == origin.parts.end() || found->second != hash)
      differing += (differing.empty() ? "" : ", ") + part;
  }
  if (differing.empty()) return;
  throw InputRefused(
      path.string() + " was written by a run of " +
      (origin.scene == scene ? "another version of " + scene : origin.scene + ", not of " + scene) +
      "; what differs: " + differing);
}

}  // namespace grainproof::report
