// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/solid/shapes.h"

namespace quoin {
namespace {

const Context context;

std::string written(MeshFormat format, const Mesh& mesh) {
  std::ostringstream out;
  write_mesh(out, format, mesh, context);
  return out.str();
}

const char* name_of(MeshFormat format) {
  switch (format) {
    case MeshFormat::off:
      return "a.off";
    case MeshFormat::obj:
      return "a.obj";
    case MeshFormat::stl_text:
    case MeshFormat::stl_binary:
      return "a.stl";
    default:
      return "a.ply";
  }
}

constexpr MeshFormat all_formats[] = {MeshFormat::off,           MeshFormat::obj,      MeshFormat::stl_text,
                                      MeshFormat::stl_binary,    MeshFormat::ply_text, MeshFormat::ply_binary_little,
                                      MeshFormat::ply_binary_big};

// A tetrahedron with coordinates that need all digits, the smallest subnormal and the largest double.
Mesh awkward() {
  Mesh mesh;
  mesh.vertices = {{0.1, 1.0 / 3.0, 5e-324},
                   {-1e-300, 2, 3},
                   {1.7976931348623157e308, 0.30000000000000004, 1},
                   {7, -2.5e17, 123456789.123456789}};
  for (const std::array<std::uint32_t, 3> f : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
    mesh.add_face(f);
  return mesh;
}

TEST(MeshFile, AwkwardDoublesComeBackBitForBit) {
  const Mesh mesh = awkward();
  for (const MeshFormat format : all_formats) {
    if (format == MeshFormat::stl_binary) continue;
    SCOPED_TRACE(name_of(format));
    const MeshFile read = read_mesh(written(format, mesh), name_of(format), {}, context);
    EXPECT_EQ(read.report.format, format);
    ASSERT_EQ(read.mesh.face_count(), mesh.face_count());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_EQ(read.mesh.vertices[read.mesh.face(f)[k]], mesh.vertices[mesh.face(f)[k]]);
    }
  }
}

TEST(MeshFile, PolygonsStayAndTrianglesWeld) {
  const Mesh box = shapes::box({0, 0, 0}, {1, 2, 3});
  for (const MeshFormat format : all_formats) {
    SCOPED_TRACE(name_of(format));
    const Mesh mesh = is_triangles_only(format) ? shapes::triangulated(box) : box;
    const MeshFile read = read_mesh(written(format, mesh), name_of(format), {}, context);
    EXPECT_EQ(read.mesh.vertices.size(), 8U);
    EXPECT_EQ(read.mesh.face_count(), is_triangles_only(format) ? 12U : 6U);
  }
  EXPECT_THROW(written(MeshFormat::stl_binary, box), InputError);
}

TEST(MeshFile, SinglePrecisionIsReported) {
  std::ostringstream out;
  Mesh mesh = shapes::triangulated(shapes::box({0, 0, 0}, {0.1, 1, 1}));
  const WriteReport report = write_mesh(out, MeshFormat::stl_binary, mesh, context);
  EXPECT_EQ(report.rounded_coordinates, 4U);
  EXPECT_GT(report.largest_rounding, 0);
  EXPECT_LT(report.largest_rounding, 1e-8);
}

TEST(MeshFile, ColorsSurvive) {
  Mesh mesh = shapes::cube();
  for (std::uint8_t f = 0; f < 6; ++f) mesh.face_colors.push_back({f, 100, 200, 255});
  for (const MeshFormat format :
       {MeshFormat::off, MeshFormat::ply_text, MeshFormat::ply_binary_little, MeshFormat::ply_binary_big}) {
    EXPECT_EQ(read_mesh(written(format, mesh), name_of(format), {}, context).mesh.face_colors, mesh.face_colors);
  }
}

TEST(MeshFile, WeldingIsExactUnlessAToleranceIsGiven) {
  const std::string text = "OFF\n4 1 0\n0 0 0\n-0 0 0\n1e-9 0 0\n1 1 1\n3 0 2 3\n";
  EXPECT_EQ(read_mesh(text, "a.off", {}, context).mesh.vertices.size(), 3U);
  ReadOptions options;
  options.weld_tolerance = 1e-8;
  const MeshFile near = read_mesh(text, "a.off", options, context);
  EXPECT_EQ(near.mesh.vertices.size(), 2U);
  EXPECT_EQ(near.report.weld_displacement, 1e-9);
}

// The message must hold `place`.
void expect_refused(const std::string& bytes, const std::string& name, const std::string& place) {
  SCOPED_TRACE(name + ": " + bytes.substr(0, 60));
  try {
    read_mesh(bytes, name, {}, context);
    FAIL() << "read without complaint";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(place), std::string::npos) << error.what();
  }
}

TEST(MeshFile, BadInputIsRefusedWithItsPlace) {
  expect_refused("", "a.off", "a.off: the file is empty");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n", "a.off", "a.off:5");
  expect_refused("OFF\r\n3 1 0\r0 0 0\n1 0 0\r\n0 1 inf\n3 0 1 2\n", "a.off", "a.off:5");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off", "a.off:6");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off", "a.off:6");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n", "a.off", "a.off:4");
  expect_refused("OFF\n999999999999 1 0\n0 0 0\n", "a.off", "a.off:2");
  expect_refused("OFF\n99999999999999999999999 1 0\n0 0 0\n", "a.off", "a.off:2");
  expect_refused("4OFF\n1 0 0\n0 0 0 0\n", "a.off", "a.off:1");
  expect_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "a.obj", "a.obj:4");
  expect_refused("v 0 0 0\nf 1 1 0\n", "a.obj", "a.obj:2");
  expect_refused("v 0 0 0\nf -1 -2 -1\n", "a.obj", "a.obj:2");
  expect_refused("v 0 0 1e999\n", "a.obj", "a.obj:1");
  expect_refused("v 0 0\n", "a.obj", "a.obj:1");
  expect_refused("v 0 0 0\nsurf 0 1\n", "a.obj", "a.obj:2");
  expect_refused("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", "a.stl", "a.stl:6");
  expect_refused("solid x\nfacet normal 0 0 1\n", "a.stl", "a.stl:2");
  expect_refused(written(MeshFormat::stl_binary, shapes::triangulated(shapes::cube())).substr(0, 300), "a.stl",
                 "byte 300");
  expect_refused(std::string(20, 'x'), "a.stl", "byte 20");
  expect_refused(
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 "
      "2\n",
      "a.ply", "a.ply:9");
  expect_refused(
      "ply\nformat ascii 1.0\nelement vertex 888888888888\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n1 2 3\n",
      "a.ply", "a.ply:8");
  expect_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n", "a.ply", "a.ply:5");
  expect_refused("ply\nformat strange 1.0\n", "a.ply", "a.ply:2");
  expect_refused("PK\3\4 something", "a.3mf", "a.3mf");
}

TEST(MeshFile, FilesThatCannotBeOpened) {
  EXPECT_THROW(read_mesh(std::filesystem::path("/nonexistent/x.off"), {}, context), FileError);
  EXPECT_THROW(read_mesh(std::filesystem::temp_directory_path(), {}, context), FileError);
  EXPECT_THROW(write_mesh(std::filesystem::path("/nonexistent/x.off"), MeshFormat::off, shapes::cube(), context),
               FileError);
}

TEST(MeshFile, UnicodeNames) {
  const auto path = std::filesystem::temp_directory_path() / "würfel-立方体.off";
  write_mesh(path, MeshFormat::off, shapes::cube(), context);
  EXPECT_EQ(read_mesh(path, {}, context).mesh.face_count(), 6U);
  std::filesystem::remove(path);
}

TEST(MeshFile, NegativeIndicesContinuationsAndForms) {
  const MeshFile file =
      read_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf -3//1 \\\n -2//1 -1//1\n", "a.obj", {}, context);
  ASSERT_EQ(file.mesh.face_count(), 1U);
  EXPECT_EQ(file.mesh.face(0)[2], 2U);
  ASSERT_EQ(file.report.warnings.size(), 1U);
}

constexpr const char* triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(MeshFile, WhatIsNoStatementOfObjIsRefused) {
  expect_refused("<!DOCTYPE html>\n<html><body>not found</body></html>\n", "a.obj", "a.obj:1: '<!DOCTYPE'");
  expect_refused("some words\nthat are no mesh\n", "a.obj", "a.obj:1: 'some'");
  expect_refused(std::string(triangle_obj) + "0.5 0.5 0.5\n", "a.obj", "a.obj:5: '0.5'");
  expect_refused(std::string(triangle_obj) + "F 1 2 3\n", "a.obj", "a.obj:5: 'F'");
  expect_refused(std::string(triangle_obj) + "\x01\x02\n", "a.obj", "a.obj:5: '?\?'");
}

// What stands behind the values of an element is another value, or nothing that is known.
TEST(MeshFile, LinesThatGoOnAreRefused) {
  for (const char* line :
       {"v 0 0 1 junk", "v 0 0 1 0,5", "v 0 0 1 1 2", "v 1 0 0 junk stuff more", "v 1 2 3 4 5 6 7 8 9"}) {
    expect_refused(std::string(triangle_obj) + line + "\n", "a.obj", "a.obj:5");
  }
  const MeshFile weighted = read_mesh(std::string(triangle_obj) + "v 0 0 1 0.5\n", "a.obj", {}, context);
  ASSERT_FALSE(weighted.report.warnings.empty());
  EXPECT_NE(weighted.report.warnings[0].find("v with weight"), std::string::npos);
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0 junk\n3 0 1 2\n", "a.off", "a.off:5");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 junk\n", "a.off", "a.off:6");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 2 3 4 5\n", "a.off", "a.off:6");
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  expect_refused(header + "0 0 0\n1 0 0\n0 1 0 3\n3 0 1 2\n", "a.ply", "a.ply:12");
  expect_refused(header + "0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply", "a.ply:10");
  EXPECT_EQ(read_mesh(header + "0 0 0 \r\n1 0 0\t\n0 1 0\n3 0 1 2", "a.ply", {}, context).mesh.face_count(), 1U);
}

TEST(MeshFile, OtherStatementsOfObjAreListed) {
  std::string text = "mtllib a.mtl\no part\n" + std::string(triangle_obj);
  const std::array ignored{"g side", "s off", "mg 0",  "usemtl steel", "vt 0 0", "vn 0 0 1",  "vp 0",
                           "l 1 2",  "p 1",   "lod 3", "con 1",        "end",    "trim 0 1 1"};
  for (const char* line : ignored) text += std::string(line) + "\n";
  const MeshFile file = read_mesh(text, "a.obj", {}, context);
  EXPECT_EQ(file.mesh.face_count(), 1U);
  EXPECT_EQ(file.mesh.name, "part");
  EXPECT_EQ(file.report.warnings.size(), ignored.size() + 1);
  EXPECT_EQ(file.report.warnings.back(), "'vt' statements are not kept: 1");
  for (const char* free_form : {"curv 0 1 1 2", "curv2 1 2", "surf 0 1 0 1 1", "cstype bezier", "parm u 0", "bmat u 1"})
    expect_refused(text + free_form + "\n", "a.obj", "a.obj:20: free-form");
}

TEST(MeshFile, FilesWithoutFacesSaySo) {
  const std::string ply = "element vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
  const std::pair<std::string, const char*> files[] = {
      {"OFF\n1 0 0\n0 0 0\n", "a.off"},
      {"v 0 0 0\n", "a.obj"},
      {"solid a\nendsolid a\n", "a.stl"},
      {written(MeshFormat::stl_binary, Mesh{}), "a.stl"},
      {"ply\nformat ascii 1.0\n" + ply + "0 0 0\n", "a.ply"},
      {"ply\nformat binary_little_endian 1.0\n" + ply + std::string(24, '\0'), "a.ply"}};
  for (const auto& [bytes, name] : files) {
    const MeshFile file = read_mesh(bytes, name, {}, context);
    SCOPED_TRACE(bytes.substr(0, 40));
    ASSERT_EQ(file.report.warnings.size(), 1U);
    EXPECT_TRUE(file.report.warnings[0].starts_with("no faces; ")) << file.report.warnings[0];
  }
}

// Data behind the declared elements: one warning with its place, and the mesh of the file without them.
TEST(MeshFile, TrailingDataIsReported) {
  const Mesh box = shapes::cube();
  const auto expect_warning = [&](MeshFormat format, const std::string& extra, const std::string& expected) {
    const std::string bytes = written(format, box);
    EXPECT_TRUE(read_mesh(bytes, name_of(format), {}, context).report.warnings.empty());
    const MeshFile file = read_mesh(bytes + extra, name_of(format), {}, context);
    EXPECT_EQ(file.mesh.corners, box.corners);
    ASSERT_EQ(file.report.warnings.size(), 1U);
    EXPECT_EQ(file.report.warnings[0].substr(0, expected.size()), expected);
  };
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const std::string off_line = std::to_string(lines(written(MeshFormat::off, box)) + 2);
  expect_warning(MeshFormat::off, "\n3 0 1 2\n", "line " + off_line + ": what follows");
  const std::string ply_line = std::to_string(lines(written(MeshFormat::ply_text, box)) + 3);
  expect_warning(MeshFormat::ply_text, " \n\r\n3 0 1 2\n", "line " + ply_line + ": what follows");
  for (const MeshFormat format : {MeshFormat::ply_binary_little, MeshFormat::ply_binary_big}) {
    const std::string byte = std::to_string(written(format, box).size());
    expect_warning(format, std::string(1, '\0'), "byte " + byte + ": what follows");
  }
  EXPECT_TRUE(read_mesh(written(MeshFormat::off, box) + "\n# the end\n", "a.off", {}, context).report.warnings.empty());
  EXPECT_TRUE(read_mesh(written(MeshFormat::ply_text, box) + " \n\n", "a.ply", {}, context).report.warnings.empty());
}

TEST(MeshFile, TextStlInAnyCase) {
  std::string text = written(MeshFormat::stl_text, shapes::triangulated(shapes::cube()));
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  ASSERT_TRUE(text.starts_with("SOLID"));
  for (const char* name : {"a.stl", "a.STL", "no ending"}) {
    const MeshFile file = read_mesh(text, name, {}, context);
    EXPECT_EQ(file.report.format, MeshFormat::stl_text);
    EXPECT_EQ(file.mesh.face_count(), 12U);
    EXPECT_EQ(file.mesh.vertices.size(), 8U);
  }
}

// The header of a binary file may hold anything, also what a text begins with.
TEST(MeshFile, BinaryStlWhoseHeaderBeginsLikeText) {
  const std::string plain = written(MeshFormat::stl_binary, shapes::triangulated(shapes::cube()));
  const MeshFile expected = read_mesh(plain, "a.stl", {}, context);
  for (const std::string word : {"solid cube", "SOLID", "facet normal", "solid\nfacet"}) {
    for (const char* name : {"a.stl", "no ending"}) {
      if (name[0] == 'n' && !word.starts_with("solid") && !word.starts_with("SOLID")) continue;
      std::string bytes = plain;
      bytes.replace(0, 80, word + std::string(80 - word.size(), ' '));
      EXPECT_TRUE(read_mesh(bytes, name, {}, context).report.warnings.empty());
      const MeshFile file = read_mesh(bytes + std::string(2, '\0'), name, {}, context);
      EXPECT_EQ(file.report.format, MeshFormat::stl_binary);
      EXPECT_EQ(file.mesh.corners, expected.mesh.corners);
      EXPECT_EQ(file.mesh.vertices, expected.mesh.vertices);
      EXPECT_EQ(file.report.warnings, std::vector<std::string>{"2 bytes behind the last triangle are not kept"});
      expect_refused(bytes.substr(0, 300), name, "byte 300: the file ends within triangle 4 of 12");
    }
  }
}

// Every prefix and every changed byte either reads or is refused.
TEST(MeshFile, TruncatedAndCorruptedFilesNeverCrash) {
  const Mesh mesh = shapes::triangulated(shapes::cube());
  for (const MeshFormat format : all_formats) {
    const std::string bytes = written(format, mesh);
    const auto attempt = [&](const std::string& changed) {
      try {
        read_mesh(changed, name_of(format), {}, context);
      } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("a."), std::string::npos) << error.what();
      }
    };
    for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 200) attempt(bytes.substr(0, length));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      for (const char c : {'\0', '-', '9', '\xFF'}) {
        std::string changed = bytes;
        changed[i] = c;
        attempt(changed);
      }
    }
  }
}

}  // namespace
}  // namespace quoin
