// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/point_file.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"
#include "quoin/io/lzf.h"
#include "quoin/io/test_point_files.h"

namespace quoin {
namespace {

using testing::PcdRow;

const Context context;

PointFile read(const std::string& bytes, const std::string& name, bool weights = false) {
  return read_points(bytes, name, {.format = {}, .weights = weights}, context);
}

constexpr const char* ply_of_floats =
    "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
    "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float nx\nproperty float ny\n"
    "property float nz\nproperty float quality\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string binary_ply() {
  std::string bytes = ply_of_floats;
  for (const float v : {0.1F, -2.5F}) {
    for (const float c : {v, 3.0F, -1e30F}) testing::append_bytes(bytes, c);
    bytes += std::string("\x01\xFF\x80", 3);
    for (const float c : {0.0F, 0.0F, 1.0F, 9.0F}) testing::append_bytes(bytes, c);
  }
  bytes += '\x03';
  for (const std::int32_t v : {0, 1, 0}) testing::append_bytes(bytes, v);
  return bytes;
}

std::vector<PcdRow> rows() {
  std::vector<PcdRow> list;
  for (int i = 0; i < 40; ++i)
    list.push_back(
        {static_cast<float>(i) / 3, static_cast<float>(i % 4), 0.1F, 0x123456U + (i < 20 ? 0U : 1U), 0.1 * i});
  return list;
}

std::string pcd_text() {
  return testing::pcd_header(3, "ascii") + "0.1 2 3 1193046 5\nnan nan nan 0 0\n-1 1e-300 7 65280 6\n";
}

TEST(PointFile, TablesOfTwoAndThreeColumns) {
  for (const char* text : {"0.1 2 3\n4 5 6\n", "0.1\t2\t3\r\n4\t5\t6", "0.1, 2, 3\r4, 5, 6\r", " 0.1;2;3;\n4;5;6;\n",
                           "\xEF\xBB\xBF# c\n\n0.1 2 3\n// d\n4 5 6\n", "\"0.1\",\"2\",\"3\"\n4,5,\"6\"\n",
                           "2\n0.1 2 3\n4 5 6\n", "1\n0.1 2 3\n1\n4 5 6\n", "0.1  2 \t3\n4 5 6\n"}) {
    for (const char* name : {"a.xyz", "a.txt", "a.csv", "a"}) {
      SCOPED_TRACE(std::string(name) + ": " + text);
      const PointFile file = read(text, name);
      EXPECT_EQ(file.dimension, 3);
      EXPECT_EQ(file.points, (std::vector<Point3>{{0.1, 2, 3}, {4, 5, 6}}));
      EXPECT_TRUE(file.report.warnings.empty());
    }
  }
  const PointFile plane = read("1 2\n3 4\n", "a.xyz");
  EXPECT_EQ(plane.dimension, 2);
  EXPECT_EQ(plane.points, (std::vector<Point3>{{1, 2, 0}, {3, 4, 0}}));
}

TEST(PointFile, NamesMayBeThoseOfStatementsAndTabsMayStandTwice) {
  EXPECT_EQ(read("g x y\n1 2 3\n", "a.txt").points, (std::vector<Point3>{{2, 3, 0}}));
  EXPECT_EQ(read("1\t\t2\n", "a.xyz").points, (std::vector<Point3>{{1, 2, 0}}));
  EXPECT_EQ(read("x\tname\ty\n1\t\t2\n", "a.xyz").points, (std::vector<Point3>{{1, 2, 0}}));
  EXPECT_THROW(read("1\t\t2\n", "a.csv"), InputError);
}

TEST(PointFile, AwkwardDoubles) {
  const PointFile file = read("5e-324 1.7976931348623157e308 0.30000000000000004\n-0 1e-400 +1\n", "a.xyz");
  EXPECT_EQ(file.points[0], (Point3{5e-324, 1.7976931348623157e308, 0.1 + 0.2}));
  EXPECT_TRUE(std::signbit(file.points[1].x));
  EXPECT_EQ(file.points[1].y, 0);
}

TEST(PointFile, ColumnsByTheirNames) {
  const PointFile file = read(
      "Z,name,\"X [m]\",Y,Red,g,BLUE,Normal_X,ny,nz,intensity\n3,\"a, "
      "\"\"b\"\"\",1,2,255,0,7,0,0,1,0.5\n6,,4,5,1,2,3,1,"
      "0,0,-2\n",
      "a.csv");
  EXPECT_EQ(file.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(file.colors, (std::vector<Color>{{255, 0, 7}, {1, 2, 3}}));
  EXPECT_EQ(file.normals, (std::vector<Vector3>{{0, 0, 1}, {1, 0, 0}}));
  EXPECT_EQ(file.intensities, (std::vector<double>{0.5, -2}));
  EXPECT_EQ(file.report.warnings, std::vector<std::string>{"1 columns are not kept: 'name'"});
  EXPECT_EQ(file.report.format, PointFormat::csv);
  const PointFile plane = read("y;x\n1;2\n", "a.csv");
  EXPECT_EQ(plane.dimension, 2);
  EXPECT_EQ(plane.points, (std::vector<Point3>{{2, 1, 0}}));
  const PointFile cloud = read("//X Y Z R G B\n1 2 3 0 0 1\n", "a.asc");
  EXPECT_EQ(cloud.colors, (std::vector<Color>{{0, 0, 255}}));
}

TEST(PointFile, ColumnsByWhatTheyHold) {
  const PointFile colors = read("1 2 3 255 0 1\n4 5 6 0 0 1\n", "a.xyz");
  EXPECT_EQ(colors.colors, (std::vector<Color>{{255, 0, 1}, {0, 0, 1}}));
  const PointFile normals = read("1 2 3 0 0 1\n4 5 6 0.6 -0.8 0\n", "a.xyz");
  EXPECT_EQ(normals.normals, (std::vector<Vector3>{{0, 0, 1}, {0.6, -0.8, 0}}));
  const PointFile both = read("1 2 3 0 0 1 9 9 9\n", "a.xyz");
  EXPECT_EQ(both.normals.size() + both.colors.size(), 2U);
  const PointFile scan = read("1\n1 2 3 -1024 10 20 30\n", "a.pts");
  EXPECT_EQ(scan.intensities, std::vector<double>{-1024});
  EXPECT_EQ(scan.colors, (std::vector<Color>{{10, 20, 30}}));
  EXPECT_EQ(scan.report.format, PointFormat::pts);
  const PointFile neither = read("1 2 3 0.5 7.5 -1\n", "a.xyz");
  EXPECT_TRUE(neither.colors.empty() && neither.normals.empty());
  EXPECT_EQ(neither.report.warnings.size(), 1U);
  EXPECT_EQ(read("1 2 3 4 5\n", "a.xyz").report.warnings, std::vector<std::string>{"2 columns are not kept"});
}

TEST(PointFile, Weights) {
  const PointFile plane = read("1 2 -3\n", "a.xyz", true);
  EXPECT_EQ(plane.dimension, 2);
  EXPECT_EQ(plane.weights, std::vector<double>{-3});
  const PointFile space = read("1 2 3 4\n", "a.xyz", true);
  EXPECT_EQ(space.points, (std::vector<Point3>{{1, 2, 3}}));
  EXPECT_EQ(space.weights, std::vector<double>{4});
  EXPECT_EQ(read("weight,x,y\n1,2,3\n", "a.csv", true).weights, std::vector<double>{1});
  EXPECT_EQ(read("v 1 2 3 0.5\n", "a.obj", true).weights, std::vector<double>{0.5});
  EXPECT_EQ(read("OFF\n1 0 0\n1 2 3 0.5\n", "a.off", true).weights, std::vector<double>{0.5});
  for (const char* text : {"x,y\n1,2\n", "1 2\n", "v 1 2 3\n", "OFF\n1 0 0\n1 2 3\n"})
    EXPECT_THROW(read(text, "a", true), InputError) << text;
}

TEST(PointFile, VerticesOfMeshes) {
  const PointFile obj = read("o a\nv 1 2 3 1 0.5 0\nvn 0 0 1\nv 4 5 6 0 0 0\nf 1//1 2//1 1\nusemtl x\n", "a.obj");
  EXPECT_EQ(read("# by hand\n\nv 1 2 3\n", "a").report.format, PointFormat::obj);
  EXPECT_EQ(obj.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(obj.colors, (std::vector<Color>{{255, 128, 0}, {0, 0, 0}}));
  EXPECT_TRUE(obj.normals.empty());
  EXPECT_TRUE(obj.report.warnings.back().starts_with("normals are not kept"));
  for (const char* faces : {"", "f 1//1 2//2\n", "f 2/5/2 1/5/1 2\n", "f 1/3 2/4\nf 1// 2//\n"}) {
    const PointFile cloud = read("v 1 2 3\nv 4 5 6\nvn 0 0 2\nvn 0 -1 0\n" + std::string(faces), "a.obj");
    EXPECT_EQ(cloud.normals, (std::vector<Vector3>{{0, 0, 2}, {0, -1, 0}})) << faces;
    EXPECT_TRUE(cloud.report.warnings.empty());
  }
  const PointFile crossed = read("v 1 2 3\nv 4 5 6\nvn 0 0 2\nvn 0 -1 0\nf 1//2 2//1\n", "a.obj");
  EXPECT_TRUE(crossed.normals.empty());
  EXPECT_EQ(crossed.report.warnings.size(), 1U);
  EXPECT_THROW(read("v 1 2 3\nvn 0 0\n", "a.obj"), InputError);
  const PointFile off = read("CNOFF\n2 1 0\n1 2 3 0 0 1 255 0 0 128\n4 5 6 0 1 0 1 2 3 4\n2 0 1\n", "a.off");
  EXPECT_EQ(off.normals.size(), 2U);
  EXPECT_EQ(off.colors, (std::vector<Color>{{255, 0, 0, 128}, {1, 2, 3, 4}}));
  const PointFile ply = read(binary_ply(), "a");
  EXPECT_EQ(ply.points, (std::vector<Point3>{{0.1F, 3, -1e30F}, {-2.5, 3, -1e30F}}));
  EXPECT_EQ(ply.colors[1], (Color{1, 255, 128}));
  EXPECT_EQ(ply.normals[0], (Vector3{0, 0, 1}));
  EXPECT_EQ(ply.report.warnings, std::vector<std::string>{"the vertex property 'quality' is not kept"});
  EXPECT_EQ(
      read("ply\nformat ascii 1.0\nelement vertex 1\nproperty double y\nproperty double x\nend_header\n1 2\n", "a")
          .points[0],
      (Point3{2, 1, 0}));
}

TEST(PointFile, CloudsOfPcd) {
  const PointFile text = read(pcd_text(), "a.pcd");
  EXPECT_EQ(text.points, (std::vector<Point3>{{0.1, 2, 3}, {-1, 1e-300, 7}}));
  EXPECT_EQ(text.colors, (std::vector<Color>{{0x12, 0x34, 0x56}, {0, 255, 0}}));
  EXPECT_EQ(text.report.missing, 1U);
  EXPECT_EQ(text.report.points_in_file, 3U);
  ASSERT_EQ(text.report.warnings.size(), 1U);
  EXPECT_EQ(text.report.warnings[0].substr(0, 21), "1 points are missing ");
  for (const std::string& bytes : {testing::pcd_binary(rows()), testing::pcd_compressed(rows())}) {
    const PointFile file = read(bytes, "cloud");
    ASSERT_EQ(file.points.size(), 40U);
    for (std::size_t i = 0; i < 40; ++i) {
      EXPECT_EQ(file.points[i], (Point3{rows()[i].x, rows()[i].y, rows()[i].z}));
      EXPECT_EQ(file.intensities[i], rows()[i].intensity);
      EXPECT_EQ(file.colors[i], (Color{0x12, 0x34, static_cast<std::uint8_t>(i < 20 ? 0x56 : 0x57)}));
    }
  }
  std::vector<PcdRow> missing = rows();
  missing[3].y = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(read(testing::pcd_compressed(missing), "a").points.size(), 39U);
  missing[3].y = std::numeric_limits<float>::infinity();
  EXPECT_THROW(read(testing::pcd_binary(missing), "a"), InputError);
}

TEST(PointFile, LzfUnpacksWhatWasPacked) {
  std::mt19937 random(3);
  for (int i = 0; i < test_rounds(200); ++i) {
    std::string bytes(random() % 2000, ' ');
    const std::size_t letters = 1 + random() % 5;
    for (char& c : bytes) c = static_cast<char>('a' + random() % letters);
    const std::string packed = testing::pack_lzf(bytes);
    EXPECT_EQ(io::unpack_lzf(packed, bytes.size(), context), bytes);
    EXPECT_EQ(io::unpack_lzf(packed, bytes.size() + 1, context), std::nullopt);
    EXPECT_EQ(io::unpack_lzf(packed, std::size_t{1} << 60, context), std::nullopt);
  }
}

/// The message must hold `place`.
void expect_refused(const std::string& bytes, const std::string& name, const std::string& place) {
  SCOPED_TRACE(name + ": " + bytes.substr(0, 80));
  try {
    read(bytes, name);
    FAIL() << "read without complaint";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
  }
}

TEST(PointFile, BadTablesAreRefusedWithTheirLine) {
  expect_refused("", "a.xyz", "a.xyz: the file is empty");
  expect_refused("# nothing\n\n", "a.xyz", "a.xyz: there are no points");
  expect_refused("0\n", "a.pts", "no points");
  expect_refused("x,y,z\n", "a.csv", "a.csv: there are no points");
  expect_refused("1 2 3\n4 5\n", "a.xyz", "a.xyz:2: 2 columns, where the first line has 3");
  expect_refused("1 2\n\n4 5 6\n", "a.xyz", "a.xyz:3: 3 columns");
  expect_refused("1 2 3\n4 nan 6\n", "a.xyz", "a.xyz:2: 'nan' in column 2 is not a finite number");
  expect_refused("1 2 inf\n", "a.xyz", "a.xyz:1: 'inf'");
  expect_refused("1 2 1e999\n", "a.xyz", "a.xyz:1: '1e999'");
  expect_refused("7\n8\n", "a.xyz", "a.xyz:1: a count of '7' does not fit");
  expect_refused("5\n1 2 3\n", "a.pts", "a.pts:2: the file ends where 4 more");
  expect_refused("1\n1 2 3\n4 5 6\n", "a.pts", "a.pts:3: there are more points than the 1");
  expect_refused("99999999999999999999999999\n1 2 3\n", "a.pts", "a.pts:1: a count of");
  expect_refused("1,5;2,5\n", "a.csv", "a.csv:1: '1,5'");
  expect_refused("x,z\n1,2\n", "a.csv", "a.csv:1: 'x' in column 1 is not a finite number, nor are there columns");
  expect_refused("x,y\n1,\n2,3\n", "a.csv", "a.csv:2: 1 columns");
  expect_refused("x,y\n,1\n", "a.csv", "a.csv:2: column 1 is empty");
  expect_refused("x,y\n\"1,2\n", "a.csv", "a.csv:2: a quote is not closed");
  expect_refused("x,y\n\"1\"2,3\n", "a.csv", "a.csv:2: a field goes on");
  expect_refused("some words that are no points", "a", "neither the content nor the ending");
  expect_refused("LASF\x01", "a.xyz", "LAS is not read");
  expect_refused("<!DOCTYPE html>\n", "a.xyz", "a.xyz:1: '<!DOCTYPE'");
}

TEST(PointFile, BadMeshesAndCloudsAreRefusedWithTheirPlace) {
  expect_refused("v 1 2 3\nv 1 2\n", "a.obj", "a.obj:2");
  expect_refused("v 1 2 3\nv 1 2 3 4 5 6\n", "a.obj", "a.obj:2");
  expect_refused("v 1 2 nan\n", "a.obj", "a.obj:1");
  expect_refused("o nothing\n", "a.obj", "no points");
  expect_refused("OFF\n3 0 0\n0 0 0\n", "a.off", "a.off:3");
  expect_refused("OFF\n888888888 0 0\n0 0 0\n", "a.off", "a.off:2");
  expect_refused("OFF\n1 1 0\n0 0 0\n", "a.off", "a.off:3: the file ends where face 0");
  expect_refused("nonsense", "a.ply", "a.ply:1");
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex ";
  const std::string xyz = "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  expect_refused(ply + "888888888888" + xyz + "1 2 3\n", "a", "a:8: a count of 888888888888");
  expect_refused(ply + "2" + xyz + "1 2 3\n", "a", "a:9: the file ends");
  expect_refused(ply + "0" + xyz, "a", "no points");
  expect_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "a", "no y");
  const std::string header = testing::pcd_header(1, "ascii");
  expect_refused(header, "a.pcd", "a.pcd:11: the file ends where point 0 of 1");
  expect_refused(header + "1 2 3 4\n", "a.pcd", "a.pcd:12: 4 numbers, where the fields are 5");
  expect_refused(header + "1 2 inf 4 5\n", "a.pcd", "a.pcd:12: 'inf'");
  expect_refused(header + "nan nan nan 4 5\n", "a.pcd", "no points but 1 that are missing");
  const std::string binary = testing::pcd_binary(rows());
  expect_refused(binary.substr(0, binary.size() - 1), "a", "byte " + std::to_string(binary.size() - 1));
  expect_refused("VERSION .7\nFIELDS x y\nSIZE 4\n", "a", "a:3: 'SIZE' has 1 words for 2 fields");
  expect_refused("VERSION .7\nFIELDS x y\nWIDTH 900000000000\nHEIGHT 900000000000\nDATA binary\n", "a", "a:5");
  expect_refused("VERSION .7\nFIELDS x y\nPOINTS 3\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2\n", "a", "POINTS is not");
  std::string packed = testing::pcd_compressed(rows());
  const std::size_t sizes = testing::pcd_header(40, "binary_compressed").size();
  packed[sizes + 4] = '\x01';
  expect_refused(packed, "a", "byte " + std::to_string(sizes + 4));
  std::string huge = testing::pcd_header(100'000'000, "binary_compressed");
  testing::append_bytes(huge, 0U);
  testing::append_bytes(huge, 2'400'000'000U);
  expect_refused(huge, "a", "do not unpack");
}

std::vector<std::pair<std::string, std::string>> samples() {
  const std::vector<PcdRow> all = rows();
  const std::vector<PcdRow> few(all.begin(), all.begin() + 12);
  return {{"a.xyz", "1 2 3 0 0 1\n4 5 6 0.6 -0.8 0\n"},
          {"b.csv", "x,\"y\",z,r,g,b\n1,2,\"3\",4,5,6\n4,5,6,7,8,9\n"},
          {"c.pts", "2\n1 2 3 -5 255 254 253\n4 5 6 9 1 2 3\n"},
          {"c.xyz", "1 2 3 255 254 253 -5 0 nan 1\n4 5 6 9 1 2 inf 0 1 0\n"},
          {"d.ply", binary_ply()},
          {"e.obj", "v 1 2 3 1 0.5 0\nv 4 5 6 0 0 0\nvn 0 nan 1\nvn 0 0 -inf\nf 1 2 1\n"},
          {"f.off", "COFF\n2 1 0\n1 2 3 255 0 0\n4 5 6 0 1 0\n2 0 1\n"},
          {"g.pcd", pcd_text()},
          {"h.pcd", testing::pcd_binary(few)},
          {"i.pcd", testing::pcd_compressed(few)}};
}

void attempt(const std::string& bytes, const std::string& name) {
  try {
    const PointFile file = read(bytes, name);
    EXPECT_FALSE(file.points.empty());
    for (const Point3& p : file.points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    for (const Vector3& n : file.normals) EXPECT_TRUE(std::isfinite(n.x) && std::isfinite(n.y) && std::isfinite(n.z));
    for (const double i : file.intensities) EXPECT_TRUE(std::isfinite(i));
    for (const std::size_t size : {file.normals.size(), file.colors.size(), file.intensities.size()})
      EXPECT_TRUE(size == 0 || size == file.points.size());
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
  }
}

TEST(PointFile, TruncatedAtEveryByte) {
  for (const auto& [name, bytes] : samples()) {
    SCOPED_TRACE(name);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      attempt(bytes.substr(0, length), name);
      attempt(bytes.substr(0, length), name.substr(0, 1));
    }
  }
}

TEST(PointFile, DamagedAtRandom) {
  std::mt19937 random(8);
  for (const auto& [name, bytes] : samples()) {
    SCOPED_TRACE(name);
    for (int i = 0; i < test_rounds(1500); ++i) {
      std::string changed = bytes;
      for (std::size_t k = 1 + random() % 3; k > 0; --k) {
        static constexpr char likely[] = "\0-9\xFF,; \n.e\"x#";
        const std::size_t at = random() % changed.size();
        changed[at] = random() % 2 == 0 ? likely[random() % (sizeof(likely) - 1)] : static_cast<char>(random());
      }
      attempt(changed, name);
    }
  }
}

TEST(PointFile, FormatsByName) {
  for (const auto format : {PointFormat::xyz, PointFormat::pts, PointFormat::csv, PointFormat::ply, PointFormat::obj,
                            PointFormat::off, PointFormat::pcd})
    EXPECT_EQ(point_format_named(name_of(format)), format);
  EXPECT_EQ(point_format_named("PCD"), PointFormat::pcd);
  EXPECT_EQ(point_format_named("las"), std::nullopt);
  EXPECT_EQ(read_points("1 0 0\n2 3 4\n", "a.ply", {.format = PointFormat::off}, context).points.size(), 1U);
}

TEST(PointFile, FilesAndCancellation) {
  EXPECT_THROW(read_points(std::filesystem::path("/nonexistent/x.xyz"), {}, context), FileError);
  EXPECT_THROW(read_points(std::filesystem::temp_directory_path(), {}, context), FileError);
  const auto path = std::filesystem::temp_directory_path() / "würfel-立方体.xyz";
  std::ofstream(path) << "1 2 3\n";
  EXPECT_EQ(read_points(path, {}, context).points.size(), 1U);
  std::filesystem::remove(path);
  Context cancelled;
  cancelled.cancel();
  EXPECT_THROW(read_points("1 2 3\n", "a.xyz", {}, cancelled), Cancelled);
}

}  // namespace
}  // namespace quoin
