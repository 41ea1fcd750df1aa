// SPDX-FileCopyrightText: 2026 The Grainproof authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cstdlib>
#include <sstream>

#include "tests/app/scenes.hpp"

namespace grainproof::testing {
namespace {

using boost::property_tree::ptree;

Scene two_spheres() {
  Scene scene = spheres_at({{1.0 / 3.0, 5e-324, 1e300}, {-0.1, 0.2, 0.30000000000000004}});
  scene.particles[1].velocity = {1e-17, -2.0 / 3.0, 0.0};
  scene.particles[1].diameter = 0.1;
  return scene;
}

ptree parsed(const std::string& xml) {
  std::istringstream stream(xml);
  ptree tree;
  read_xml(stream, tree);
  return tree;
}

/// The numbers of the DataArray of this name; "" is the one without a name.
std::vector<double> numbers_of(const ptree& parent, const std::string& name) {
  for (const auto& [tag, array] : parent) {
    if (tag != "DataArray" || array.get("<xmlattr>.Name", "") != name) continue;
    std::istringstream stream(array.data());
    std::vector<double> numbers;
    for (std::string word; stream >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
    return numbers;
  }
  return {};
}

std::vector<double> flat(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  for (const Vec3& vector : vectors) numbers.insert(numbers.end(), vector.data(), vector.data() + 3);
  return numbers;
}

TEST(VtpFrame, ReadsBackAsTheSameNumbers) {
  const Scene scene = two_spheres();
  const Frame frame = frame_of(scene, 3);
  const ptree poly = parsed(report::vtp_text(scene, frame)).get_child("VTKFile.PolyData");
  const ptree& piece = poly.get_child("Piece");
  EXPECT_EQ(piece.get<int>("<xmlattr>.NumberOfPoints"), 2);
  EXPECT_EQ(numbers_of(piece.get_child("Points"), ""), flat(frame.position));
  EXPECT_EQ(numbers_of(piece.get_child("PointData"), "velocity"), flat(frame.velocity));
  EXPECT_EQ(numbers_of(piece.get_child("PointData"), "id"), (std::vector<double>{7, 17}));
  EXPECT_EQ(numbers_of(piece.get_child("PointData"), "diameter"), (std::vector<double>{1.0, 0.1}));
  EXPECT_EQ(numbers_of(piece.get_child("Verts"), "offsets"), (std::vector<double>{1, 2}));
  EXPECT_EQ(numbers_of(poly.get_child("FieldData"), "TimeValue"), std::vector<double>{frame.time});
}

TEST(PvdCollection, NamesEveryFrameWithItsTime) {
  const ptree collection = parsed(report::pvd_text({0.0, 0.1})).get_child("VTKFile.Collection");
  std::vector<std::string> files;
  std::vector<double> times;
  for (const auto& [tag, set] : collection) {
    if (tag != "DataSet") continue;
    files.push_back(set.get<std::string>("<xmlattr>.file"));
    times.push_back(set.get<double>("<xmlattr>.timestep"));
  }
  EXPECT_EQ(files, (std::vector<std::string>{"frame_000000.vtp", "frame_000001.vtp"}));
  EXPECT_EQ(times, (std::vector<double>{0.0, 0.1}));
}

TEST(CsvFrame, ReadsBackAsTheSameNumbers) {
  const Scene scene = two_spheres();
  std::string text = report::csv_text(scene, frame_of(scene, 3));
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  for (std::string word; words >> word;) numbers.push_back(std::strtod(word.c_str(), nullptr));
  const double t = frame_of(scene, 3).time;
  EXPECT_EQ(numbers, (std::vector<double>{t, 7, 1.0 / 3.0, 5e-324, 1e300, 0, 0, 0, t, 17, -0.1, 0.2,
                                          0.30000000000000004, 1e-17, -2.0 / 3.0, 0}));
}

TEST(Frames, HaveAngularVelocitiesWhereBodiesTurn) {
  Scene scene = two_spheres();
  scene.rotation = true;
  Frame frame = frame_of(scene, 3);
  frame.angular_velocity = {{1.0 / 7.0, -2.0, 3e-9}, {0.0, 0.1, 5.0}};
  const ptree piece = parsed(report::vtp_text(scene, frame)).get_child("VTKFile.PolyData.Piece");
  EXPECT_EQ(numbers_of(piece.get_child("PointData"), "angular_velocity"), flat(frame.angular_velocity));
  const std::string text = report::csv_text(scene, frame);
  EXPECT_NE(text.find(",0.14285714285714285,-2,3e-09\n"), std::string::npos) << text;
  EXPECT_EQ(std::string(report::csv_header(scene)), "time,id,x,y,z,vx,vy,vz,wx,wy,wz\n");
}

TEST(Frames, HaveOrientationsWhereTheSceneKeepsThem) {
  Scene scene = two_spheres();
  scene.orientation = OrientationUpdate::exponential;
  Frame frame = frame_of(scene, 3);
  frame.orientation = {Quaternion(0.5, -0.5, 0.5, 0.5), Quaternion(1.0, 0.0, 0.0, 1.0 / 7.0)};
  const ptree piece = parsed(report::vtp_text(scene, frame)).get_child("VTKFile.PolyData.Piece");
  EXPECT_EQ(numbers_of(piece.get_child("PointData"), "orientation"),
            (std::vector<double>{0.5, -0.5, 0.5, 0.5, 1.0, 0.0, 0.0, 1.0 / 7.0}));
  EXPECT_NE(report::csv_text(scene, frame).find(",0.5,-0.5,0.5,0.5\n"), std::string::npos);
  EXPECT_EQ(report::csv_header(scene), "time,id,x,y,z,vx,vy,vz,qw,qx,qy,qz\n");
}

TEST(FrameWriter, RefusesAFolderItCannotWriteTo) {
  EXPECT_THROW(report::FrameWriter("/proc/nowhere", two_spheres(), true), std::filesystem::filesystem_error);
}

}  // namespace
}  // namespace grainproof::testing
