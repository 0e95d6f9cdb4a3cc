// SPDX-License-Identifier: Apache-2.0
//
// What is known of the vertices of a mesh: written, and read as points.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "quoin/base/test_rounds.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/point_file.h"

namespace quoin {
namespace {

struct Sample {
  Mesh mesh;
  VertexData data;
};

Sample random_sample(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-2, 2);
  Sample sample;
  for (int i = 0; i < 5; ++i) {
    sample.mesh.vertices.push_back({number(random), number(random), number(random)});
    sample.data.normals.push_back({number(random), number(random), number(random)});
    const auto channel = [&] { return static_cast<std::uint8_t>(random()); };
    sample.data.colors.push_back({channel(), channel(), channel(), channel()});
    sample.data.intensities.push_back(number(random));
    sample.data.weights.push_back(number(random));
  }
  sample.mesh.add_face(std::array{0U, 1U, 2U});
  sample.mesh.add_face(std::array{2U, 3U, 4U, 0U});
  if (random() % 2 == 0) sample.data.normals.clear();
  if (random() % 2 == 0) sample.data.colors.clear();
  if (random() % 2 == 0) sample.data.intensities.clear();
  if (random() % 2 == 0) sample.data.weights.clear();
  if (random() % 2 == 0) sample.mesh.face_colors = {{1, 2, 3, 4}, {5, 6, 7, 255}};
  return sample;
}

TEST(VertexData, PlyHoldsAllOfIt) {
  std::mt19937 random(4);
  for (int round = 0; round < test_rounds(40); ++round) {
    const Sample sample = random_sample(random);
    for (const MeshFormat format : {MeshFormat::ply_text, MeshFormat::ply_binary_little, MeshFormat::ply_binary_big}) {
      std::ostringstream out;
      EXPECT_TRUE(write_mesh(out, format, sample.mesh, Context(), sample.data).dropped_vertex_data.empty());
      const bool has_weights = !sample.data.weights.empty();
      const PointFile points = read_points(out.str(), "x.ply", {.format = {}, .weights = has_weights}, Context());
      EXPECT_EQ(points.points, sample.mesh.vertices);
      EXPECT_EQ(points.normals, sample.data.normals);
      EXPECT_EQ(points.colors, sample.data.colors);
      EXPECT_EQ(points.intensities, sample.data.intensities);
      EXPECT_EQ(points.weights, sample.data.weights);
      const Mesh mesh = read_mesh(out.str(), "x.ply", {.weld = false, .weld_tolerance = {}}, Context()).mesh;
      EXPECT_EQ(mesh.vertices, sample.mesh.vertices);
      EXPECT_EQ(mesh.corners, sample.mesh.corners);
      EXPECT_EQ(mesh.face_colors, sample.mesh.face_colors);
    }
  }
}

TEST(VertexData, ObjHoldsColoursAndNormals) {
  std::mt19937 random(9);
  Sample sample = random_sample(random);
  for (const std::uint8_t opacity : {std::uint8_t{255}, std::uint8_t{100}}) {
    sample.data = {.normals = {5, Vector3{0, 0.6, 0.8}}, .colors = {}, .intensities = {1, 2, 3, 4, 5}, .weights = {}};
    for (int i = 0; i < 5; ++i)
      sample.data.colors.push_back({static_cast<std::uint8_t>(50 * i), static_cast<std::uint8_t>(i), 77, opacity});
    std::ostringstream out;
    const WriteReport report = write_mesh(out, MeshFormat::obj, sample.mesh, Context(), sample.data);
    EXPECT_EQ(report.dropped_vertex_data, std::vector<std::string>{"intensities"});
    EXPECT_NE(out.str().find("vn 0 0.6 0.8\n"), std::string::npos);
    EXPECT_NE(out.str().find("f 1//1 2//2 3//3\n"), std::string::npos);
    EXPECT_EQ(read_points(out.str(), "x.obj", {}, Context()).colors, sample.data.colors);
    EXPECT_EQ(read_mesh(out.str(), "x.obj", {.weld = false, .weld_tolerance = {}}, Context()).mesh.corners,
              sample.mesh.corners);
  }
}

TEST(VertexData, OtherFormatsSayWhatTheyDrop) {
  std::mt19937 random(9);
  Sample sample = random_sample(random);
  sample.data = {
      .normals = {5, Vector3{0, 0, 1}}, .colors = {5, Color{}}, .intensities = {}, .weights = {1, 2, 3, 4, 5}};
  std::ostringstream out;
  EXPECT_EQ(write_mesh(out, MeshFormat::off, sample.mesh, Context(), sample.data).dropped_vertex_data,
            (std::vector<std::string>{"normals", "colours", "weights"}));
}

}  // namespace
}  // namespace quoin
