// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/sphere_curves.h"

#include <gtest/gtest.h>

#include "quoin/arrangement/geodesic/geodesic_arrangement.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

dcel::Counts counts_of(const std::string& text) {
  GeodesicFamily family;
  PieceList<GeodesicFamily> list;
  std::vector<std::string> names;
  read_sphere_curves(text, "text", family, list, names);
  EXPECT_EQ(names.size(), list.curve_count);
  return arrange(std::move(family), std::move(list), Context()).counts();
}

std::string refusal(const std::string& text) {
  try {
    counts_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SphereCurves, OctantsAndPoints) {
  const dcel::Counts counts = counts_of("# octants\ncircle 1 0 0\ncircle 0 2 0\n\nCIRCLE 0 0 1/3\npoint 1 1 1\n");
  EXPECT_EQ(counts.vertices, 7U);
  EXPECT_EQ(counts.isolated_vertices, 1U);
  EXPECT_EQ(counts.edges, 12U);
  EXPECT_EQ(counts.faces, 8U);
}

TEST(SphereCurves, ArcsWithAndWithoutNormals) {
  EXPECT_EQ(counts_of("arc 1 0 0 0 1 0").faces, 1U);
  EXPECT_EQ(counts_of("arc 1 0 0 0 1 0\narc 0 1 0 0 0 1\narc 0 0 1 1 0 0").faces, 2U);
  EXPECT_EQ(counts_of("arc 1 0 0 -1 0 0 0 0 1\narc -1 0 0 1 0 0 0 0 1").faces, 2U);
}

TEST(SphereCurves, RefusalsNameTheLine) {
  EXPECT_TRUE(refusal("circle 1 0 0\narc 1 0 0 -1 0 0").starts_with("text:2: "));
  EXPECT_TRUE(refusal("arc 1 0 0 1 0 0").starts_with("text:1: "));
  EXPECT_TRUE(refusal("circle 0 0 0").starts_with("text:1: "));
  EXPECT_TRUE(refusal("circle 1 0").starts_with("text:1: "));
  EXPECT_TRUE(refusal("circle 1 0 x").starts_with("text:1: "));
  EXPECT_TRUE(refusal("circle 1 0 1/0").starts_with("text:1: "));
  EXPECT_TRUE(refusal("\n\nblob 1 2 3").starts_with("text:3: "));
  EXPECT_TRUE(refusal("circle nan 0 0").starts_with("text:1: "));
}

TEST(SphereCurves, NothingIsTheWholeSphere) {
  EXPECT_EQ(counts_of("").faces, 1U);
}

}  // namespace
}  // namespace quoin
