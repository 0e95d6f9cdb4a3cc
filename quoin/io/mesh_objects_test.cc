// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/mesh_objects.h"

#include <gtest/gtest.h>

namespace quoin {
namespace {

std::vector<MeshObject> objects_in(const std::string& text) {
  const Context context({.threads = 1});
  return objects_of(read_mesh(text, "x.obj", {}, context), context);
}

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\n";

TEST(MeshObjects, NoneWithoutLinesThatNameThem) {
  EXPECT_TRUE(objects_in(vertices + "f 1 2 3\n").empty());
}

TEST(MeshObjects, ObjectsAndTheirGroups) {
  const auto objects =
      objects_in(vertices + "o first part\ng a\nf 1 2 3\ng b\nf 1 2 4\ng a\nf 2 3 4\no second\nf 3 4 5\n");
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[0].name, "first part");
  ASSERT_EQ(objects[0].groups.size(), 2U);
  EXPECT_EQ(objects[0].groups[0].face_count(), 2U);
  EXPECT_EQ(objects[0].groups[0].vertices.size(), 4U);
  EXPECT_EQ(objects[0].groups[1].face_count(), 1U);
  EXPECT_EQ(objects[0].groups[1].vertices.size(), 3U);
  EXPECT_EQ(objects[0].whole.face_count(), 3U);
  EXPECT_EQ(objects[0].whole.vertices.size(), 4U);
  EXPECT_EQ(objects[1].name, "second");
  ASSERT_EQ(objects[1].groups.size(), 1U);
  const Mesh& last = objects[1].groups[0];
  ASSERT_EQ(last.vertices.size(), 3U);
  EXPECT_EQ(last.vertices[last.face(0)[2]], (Point3{5, 5, 5}));
}

TEST(MeshObjects, GroupsAreObjectsWhereThereAreNoOthers) {
  const auto objects = objects_in(vertices + "f 1 2 3\ng left\nf 1 2 4\ng right\nf 3 4 5\ng empty\n");
  ASSERT_EQ(objects.size(), 3U);
  EXPECT_EQ(objects[0].name, "");
  EXPECT_EQ(objects[1].name, "left");
  EXPECT_EQ(objects[2].name, "right");
  EXPECT_EQ(objects[2].groups.size(), 1U);
}

TEST(MeshObjects, WeldingKeepsFacesInTheirGroups) {
  const auto objects = objects_in("o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf 4 5 6\n");
  ASSERT_EQ(objects.size(), 2U);
  EXPECT_EQ(objects[1].groups[0].vertices.size(), 3U);
  EXPECT_EQ(objects[1].groups[0].vertices[objects[1].groups[0].face(0)[2]], (Point3{0, 0, 1}));
}

}  // namespace
}  // namespace quoin
