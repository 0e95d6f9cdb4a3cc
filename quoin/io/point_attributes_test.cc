// SPDX-License-Identifier: Apache-2.0
//
// Normals and colours in every format of points, and what is not finite among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "quoin/base/error.h"
#include "quoin/io/point_file.h"
#include "quoin/io/test_point_files.h"

namespace quoin {
namespace {

using testing::PcdColumn;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();
const Context context;

PointFile read(const std::string& bytes, const std::string& name, bool weights = false) {
  return read_points(bytes, name, {.format = {}, .weights = weights}, context);
}

std::string refusal(const std::string& bytes, const std::string& name, bool weights = false) {
  try {
    read(bytes, name, weights);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without complaint";
}

std::string taken_for_zero(int count, const std::string& what, const std::string& first) {
  return std::to_string(count) + " numbers of " + what + " are not finite or too large, the first at " + first +
         ": taken for 0";
}
constexpr const char* attributes = "normals, colours or intensities";

/// Three points with normals, colours packed into floats, and intensities.
std::vector<PcdColumn> cloud() {
  return {{"x", 'F', 4, {1, 2, 3}},           {"y", 'F', 4, {0.5, 0.25, 0}},
          {"z", 'F', 4, {-1, -2, -3}},        {"rgb", 'F', 4, {0x123456, 0x00FF00, 0x010203}, true},
          {"normal_x", 'F', 4, {0, 0.5, -1}}, {"normal_y", 'F', 4, {0, -0.5, 0}},
          {"normal_z", 'F', 4, {1, 0.75, 0}}, {"intensity", 'F', 8, {0.1, 0.2, 0.3}}};
}

TEST(PointAttributes, OfPcd) {
  for (const char* data : {"ascii", "binary", "binary_compressed"}) {
    SCOPED_TRACE(data);
    const PointFile file = read(testing::pcd_file(cloud(), data), "a.pcd");
    EXPECT_EQ(file.points, (std::vector<Point3>{{1, 0.5, -1}, {2, 0.25, -2}, {3, 0, -3}}));
    EXPECT_EQ(file.normals, (std::vector<Vector3>{{0, 0, 1}, {0.5, -0.5, 0.75}, {-1, 0, 0}}));
    EXPECT_EQ(file.colors, (std::vector<Color>{{0x12, 0x34, 0x56}, {0, 255, 0}, {1, 2, 3}}));
    EXPECT_EQ(file.intensities, (std::vector<double>{0.1, 0.2, 0.3}));
    EXPECT_EQ(file.report.warnings, std::vector<std::string>());
  }
}

TEST(PointAttributes, OfPcdWhereTheBitsOfColoursAreNoNumber) {
  std::vector<PcdColumn> columns = cloud();
  columns[3].values = {0xFF923456, 0x7F800000, 0xFFC00001};  // NaN, infinity, NaN
  for (const char* data : {"binary", "binary_compressed"}) {
    const PointFile file = read(testing::pcd_file(columns, data), "a.pcd");
    EXPECT_EQ(file.colors, (std::vector<Color>{{0x92, 0x34, 0x56}, {0x80, 0, 0}, {0xC0, 0, 1}})) << data;
    EXPECT_EQ(file.report.warnings, std::vector<std::string>()) << data;
  }
  const PointFile text = read(testing::pcd_file(columns, "ascii"), "a.pcd");  // that has lost the bits
  EXPECT_EQ(text.colors, std::vector<Color>(3, {0, 0, 0}));
  EXPECT_EQ(text.report.warnings, std::vector<std::string>{taken_for_zero(3, attributes, "line 12")});
}

TEST(PointAttributes, OfPcdThatAreNotFinite) {
  std::vector<PcdColumn> columns = cloud();
  columns[4].values[1] = nan;
  columns[5].values[1] = nan;
  columns[6].values[2] = -inf;
  columns[7].values[2] = inf;
  for (const auto& [data, first] :
       {std::pair("ascii", "line 13"), std::pair("binary", "point 1"), std::pair("binary_compressed", "point 1")}) {
    SCOPED_TRACE(data);
    const PointFile file = read(testing::pcd_file(columns, data), "a.pcd");
    EXPECT_EQ(file.normals, (std::vector<Vector3>{{0, 0, 1}, {0, 0, 0.75}, {-1, 0, 0}}));
    EXPECT_EQ(file.intensities, (std::vector<double>{0.1, 0.2, 0}));
    EXPECT_EQ(file.report.warnings, std::vector<std::string>{taken_for_zero(4, attributes, first)});
    std::vector<PcdColumn> missing = columns;
    missing[0].values[1] = nan;  // what is missing has no normal either
    const PointFile rest = read(testing::pcd_file(missing, data), "a.pcd");
    EXPECT_EQ(rest.points.size(), 2U);
    EXPECT_EQ(rest.report.warnings[0],
              taken_for_zero(2, attributes, data == std::string("ascii") ? "line 14" : "point 2"));
    missing[0].values[1] = inf;
    EXPECT_NE(refusal(testing::pcd_file(missing, data), "a.pcd"), "read without complaint");
  }
  EXPECT_EQ(refusal(testing::pcd_header(1, "ascii") + "1 2 3 4 abc\n", "a.pcd"), "a.pcd:12: 'abc' is not a number");
  EXPECT_EQ(refusal(testing::pcd_header(1, "ascii") + "1 -inf 3 4 5\n", "a.pcd"),
            "a.pcd:12: '-inf' in column 2 is not finite");
}

TEST(PointAttributes, OfTablesThatAreNotFinite) {
  const std::vector<Vector3> normals{{0, 0, 1}, {0, 0.6, 0}, {0, 0, 0}};
  const std::string numbers = "1 2 3 0 0 1\n4 5 6 nan 0.6 -inf\n7 8 9 +NaN INF 1e999\n";
  std::string commas = numbers;
  std::ranges::replace(commas, ' ', ',');
  for (const auto& [bytes, name, line] :
       {std::tuple(numbers, "a.xyz", 2), std::tuple("3\n" + numbers, "a.pts", 3), std::tuple(commas, "a.csv", 2),
        std::tuple("x,y,z,nx,ny,nz\n" + commas, "b.csv", 3), std::tuple("# x y z nx ny nz\n" + numbers, "b.txt", 3)}) {
    SCOPED_TRACE(bytes);
    const PointFile file = read(bytes, name);
    EXPECT_EQ(file.normals, normals);
    EXPECT_EQ(file.report.warnings,
              std::vector<std::string>{taken_for_zero(5, attributes, "line " + std::to_string(line))});
  }
  const PointFile scan = read("1 2 3 inf 255 1 2\n4 5 6 7 8 -nan 9\n", "a.xyz");
  EXPECT_EQ(scan.intensities, (std::vector<double>{0, 7}));
  EXPECT_EQ(scan.colors, (std::vector<Color>{{255, 1, 2}, {8, 0, 9}}));
  EXPECT_EQ(scan.report.warnings, std::vector<std::string>{taken_for_zero(2, attributes, "line 1")});
  EXPECT_EQ(read("1 2 3 nan nan nan\n", "a.xyz").normals.size(), 0U);  // that may be anything
}

TEST(PointAttributes, OfTablesThatAreNotKeptAreNotCounted) {
  EXPECT_EQ(read("1 2 3 nan inf\n", "a.xyz").report.warnings, std::vector<std::string>{"2 columns are not kept"});
  EXPECT_EQ(read("1 2 3 nan 7 9.5\n4 5 6 2 2 0.5\n", "a.xyz").report.warnings,
            std::vector<std::string>{
                "columns 4 to 6 are no colours from 0 to 255 and no normals of length 1, or a second time: not kept"});
  EXPECT_EQ(read("x,y,r,g,b\n1,2,nan,300,0\n", "a.csv").report.warnings,
            std::vector<std::string>{"colours beyond 0 to 255 are not kept"});
}

TEST(PointAttributes, WordsThatAreNoNumbersAreRefused) {
  EXPECT_EQ(refusal("1 2 3 0 0 1\n4 5 6 0 abc 1\n", "a.xyz"), "a.xyz:2: 'abc' in column 5 is not a number");
  EXPECT_EQ(refusal("1 2 3 0 0 nano\n", "a.pts"),
            "a.pts:1: 'nano' in column 6 is not a number, nor are there columns named x and y");
  EXPECT_EQ(refusal("x,y,nx,ny,nz\n1,2,0,,1\n", "a.csv"), "a.csv:2: column 4 is empty");
  EXPECT_EQ(refusal("v 1 2 3\nvn 0 0 n\n", "a.obj"), "a.obj:2: 'n' is not a number");
}

TEST(PointAttributes, CoordinatesAndWeightsMustBeFinite) {
  EXPECT_EQ(refusal("1 2 3 0 0 1\n4 5 nan 0 0 1\n", "a.xyz"), "a.xyz:2: 'nan' in column 3 is not a finite number");
  EXPECT_EQ(refusal("x,nx,ny,nz,y\n1,0,0,1,-inf\n", "a.csv"), "a.csv:2: '-inf' in column 5 is not a finite number");
  EXPECT_EQ(refusal("1 2 3 4\n1 2 3 nan\n", "a.xyz", true), "a.xyz:2: 'nan' in column 4 is not a finite number");
  EXPECT_EQ(refusal("v 1 2 3\nv 1 2 inf\n", "a.obj"), "a.obj:2: 'inf' is not a finite number");
  EXPECT_EQ(refusal("OFF\n1 0 0\n1 nan 3\n", "a.off"), "a.off:3: 'nan' is not a finite number");
  const PointFile unasked = read("x,y,w\n1,2,nan\n", "a.csv");  // that no one asks for
  EXPECT_TRUE(unasked.weights.empty());
  EXPECT_EQ(unasked.report.warnings, std::vector<std::string>{"1 columns are not kept: 'w'"});
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty "
         "float "
         "ny\nproperty float nz\nproperty float quality\nend_header\n";
}

TEST(PointAttributes, OfPlyThatAreNotFinite) {
  constexpr auto none = std::numeric_limits<float>::quiet_NaN();
  constexpr auto far = std::numeric_limits<float>::infinity();
  std::string binary = ply_header("binary_little_endian");
  for (const float v :
       {1.F, 2.F, 3.F, 0.F, 0.F, 1.F, none, 4.F, 5.F, 6.F, 0.F, none, 1.F, far, 7.F, 8.F, 9.F, 0.F, -far, 1.F, 0.F})
    testing::append_bytes(binary, v);
  const std::string header = ply_header("ascii");
  const std::string text = header + "1 2 3 0 0 1 nan\n4 5 6 0 NaN 1 inf\n7 8 9 0 -inf 1 0\n";
  for (const auto& [bytes, first] : {std::pair(binary, "vertex 1"), std::pair(text, "line 13")}) {
    const PointFile file = read(bytes, "a");
    EXPECT_EQ(file.normals, std::vector<Vector3>(3, {0, 0, 1}));
    EXPECT_EQ(file.report.warnings, (std::vector<std::string>{"the vertex property 'quality' is not kept",
                                                              taken_for_zero(2, attributes, first)}));
  }
  EXPECT_EQ(refusal(header + "1 2 3 0 0 1 0\n4 inf 6 0 0 1 0\n7 8 9 0 0 1 0\n", "a"),
            "a:13: vertex 1 has a 'y' that is not finite");
  EXPECT_EQ(refusal(header + "1 2 3 0 0 1 0\n4 5 6 0 no 1 0\n7 8 9 0 0 1 0\n", "a"), "a:13: 'no' is not a number");
}

TEST(PointAttributes, OfMeshesThatAreNotFinite) {
  const PointFile obj = read("v 1 2 3\nv 4 5 6\nvn 0 0 1\nvn nan 0 inf\n", "a.obj");
  EXPECT_EQ(obj.normals, (std::vector<Vector3>{{0, 0, 1}, {0, 0, 0}}));
  EXPECT_EQ(obj.report.warnings, std::vector<std::string>{taken_for_zero(2, "normals", "line 4")});
  const PointFile lost = read("v 1 2 3\nvn 0 0 1\nvn nan 0 inf\n", "a.obj");
  EXPECT_EQ(lost.report.warnings.size(), 1U);
  EXPECT_TRUE(lost.report.warnings[0].starts_with("normals are not kept"));
  const PointFile colored = read("v 1 2 3 255 nan 1\n", "a.obj");
  EXPECT_EQ(colored.colors, (std::vector<Color>{{255, 0, 1}}));
  EXPECT_EQ(colored.report.warnings, std::vector<std::string>{taken_for_zero(1, attributes, "line 1")});
  const PointFile off = read("CNOFF\n2 0 0\n1 2 3 0 0 1 255 0 0\n4 5 6 nan nan nan 1 2 inf\n", "a.off");
  EXPECT_EQ(off.normals, (std::vector<Vector3>{{0, 0, 1}, {0, 0, 0}}));
  EXPECT_EQ(off.colors, (std::vector<Color>{{255, 0, 0}, {1, 2, 0}}));
  EXPECT_EQ(off.report.warnings, std::vector<std::string>{taken_for_zero(4, attributes, "line 4")});
}

}  // namespace
}  // namespace quoin
