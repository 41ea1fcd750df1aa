// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/frames.hpp"

#include <cstdio>

#include "report/files.hpp"
#include "report/numbers.hpp"

namespace grainproof::report {
namespace {

std::string frame_name(std::size_t index) {
  char name[32];
  std::snprintf(name, sizeof name, "frame_%06zu.vtp", index);
  return name;
}

std::string vector_text(const Vec3& value, char between) {
  return exact(value.x()) + between + exact(value.y()) + between + exact(value.z());
}

std::string vectors_text(const std::vector<Vec3>& values) {
  std::string text;
  for (const Vec3& value : values) text += vector_text(value, ' ') + "\n";
  return text;
}

std::string quaternion_text(const Quaternion& turn, char between) {
  return exact(turn.w()) + between + vector_text(turn.vec(), between);
}

std::string array_text(const std::string& attributes, const std::string& values) {
  return "<DataArray " + attributes + " format=\"ascii\">\n" + values + "</DataArray>\n";
}

std::string point_data(const Scene& scene, const Frame& frame) {
  std::string ids;
  std::string diameters;
  for (const Particle& particle : scene.particles) {
    ids += std::to_string(particle.id) + "\n";
    diameters += exact(particle.diameter) + "\n";
  }
  const std::string spins =
      frame.angular_velocity.empty()
          ? ""
          : array_text(R"(type="Float64" Name="angular_velocity" NumberOfComponents="3")",
                       vectors_text(frame.angular_velocity));
  std::string turns;
  for (const Quaternion& turn : frame.orientation) turns += quaternion_text(turn, ' ') + "\n";
  if (!turns.empty())
    turns = array_text(R"(type="Float64" Name="orientation" NumberOfComponents="4")", turns);
  return "<PointData Vectors=\"velocity\" Scalars=\"diameter\">\n" +
         array_text(R"(type="Float64" Name="velocity" NumberOfComponents="3")",
                    vectors_text(frame.velocity)) +
         spins + turns + array_text(R"(type="Int64" Name="id")", ids) +
         array_text(R"(type="Float64" Name="diameter")", diameters) + "</PointData>\n";
}

// One vertex cell a particle, so that filters which work on cells see them too.
std::string vertices(std::size_t count) {
  std::string connectivity;
  std::string offsets;
  for (std::size_t i = 0; i < count; ++i) {
    connectivity += std::to_string(i) + "\n";
    offsets += std::to_string(i + 1) + "\n";
  }
  return "<Verts>\n" + array_text(R"(type="Int64" Name="connectivity")", connectivity) +
         array_text(R"(type="Int64" Name="offsets")", offsets) + "</Verts>\n";
}

}  // namespace

std::string vtp_text(const Scene& scene, const Frame& frame) {
  const std::string count = std::to_string(frame.position.size());
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
         "<PolyData>\n<FieldData>\n" +
         array_text(R"(type="Float64" Name="TimeValue" NumberOfTuples="1")", exact(frame.time) + "\n") +
         "</FieldData>\n<Piece NumberOfPoints=\"" + count + "\" NumberOfVerts=\"" + count +
         "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n" + point_data(scene, frame) +
         "<Points>\n" + array_text(R"(type="Float64" NumberOfComponents="3")", vectors_text(frame.position)) +
         "</Points>\n" + vertices(frame.position.size()) + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

std::string pvd_text(const std::vector<double>& times) {
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
  for (std::size_t i = 0; i < times.size(); ++i)
    text += "<DataSet timestep=\"" + exact(times[i]) + "\" file=\"" + frame_name(i) + "\"/>\n";
  return text + "</Collection>\n</VTKFile>\n";
}

std::string csv_header(const Scene& scene) {
  return std::string("time,id,x,y,z,vx,vy,vz") + (scene.rotation ? ",wx,wy,wz" : "") +
         (scene.orientation == OrientationUpdate::none ? "" : ",qw,qx,qy,qz") + "\n";
}

std::string csv_text(const Scene& scene, const Frame& frame) {
  std::string text;
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    text += exact(frame.time) + "," + std::to_string(scene.particles[i].id) + "," +
            vector_text(frame.position[i], ',') + "," + vector_text(frame.velocity[i], ',');
    if (!frame.angular_velocity.empty())
      text.append(1, ',').append(vector_text(frame.angular_velocity[i], ','));
    if (!frame.orientation.empty()) text.append(1, ',').append(quaternion_text(frame.orientation[i], ','));
    text += "\n";
  }
  return text;
}

FrameWriter::FrameWriter(std::filesystem::path folder, const Scene& scene, bool csv)
    : folder_(std::move(folder)), scene_(scene) {
  std::filesystem::create_directories(folder_);
  if (!csv) return;
  csv_.open(folder_ / "frames.csv");
  csv_ << csv_header(scene);
}

void FrameWriter::write(const Frame& frame) {
  write_file(folder_ / frame_name(times_.size()), vtp_text(scene_, frame));
  times_.push_back(frame.time);
  write_file(folder_ / "frames.pvd", pvd_text(times_));
  if (csv_.is_open()) require_written(csv_ << csv_text(scene_, frame) << std::flush, folder_ / "frames.csv");
}

}  // namespace grainproof::report
