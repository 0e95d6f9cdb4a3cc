// SPDX-License-Identifier: Apache-2.0
#include "quoin/view/arrangement_picture.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "quoin/arrangement/circular/circular_arrangement.h"
#include "quoin/arrangement/linear/linear_arrangement.h"
#include "quoin/arrangement/linear/linear_location.h"
#include "quoin/view/circular_picture.h"
#include "quoin/view/decomposition_picture.h"
#include "quoin/view/face_pole.h"
#include "quoin/view/picture_svg.h"

namespace quoin {
namespace {

using Generator = std::mt19937;

bool is_inside(const PictureFace& face, const Point2& p) {
  bool inside = face.is_outside;
  for (const PicturePath& ring : face.rings) {
    const std::vector<Point2> polygon = flattened(ring, 1e-3);
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
      const Point2& a = polygon[i];
      const Point2& b = polygon[j];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
  }
  return inside;
}

/// Segments, rays and lines on a small grid, where much is parallel, vertical, overlapping or touching.
LinearArrangement arrangement(Generator& random, int round) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  const auto pick = [&] { return static_cast<double>(random() % static_cast<unsigned>(2 + round % 7)); };
  const int count = round % 13;
  for (int i = 0; i < count; ++i) {
    const Point2 a{pick(), pick()};
    const Point2 b{pick(), pick()};
    if (a == b)
      family.add_point(list, a);
    else if (round % 3 == 0)
      family.add_segment(list, a, b);
    else if ((round + i) % 3 == 1)
      family.add_ray(list, a, b);
    else
      family.add_line(list, a, b, "line");
  }
  return arrange(std::move(family), list, Context());
}

void expect_tiles(const PlanarPicture& picture, Generator& random, int round) {
  ASSERT_NO_THROW(check_picture(picture)) << round;
  const PictureBox box = shown_box(picture);
  for (int sample = 0; sample < 20; ++sample) {
    const auto part = [&] { return static_cast<double>(random() % 1000003) / 1000003; };
    const Point2 p{box.low.x + part() * box.width(), box.low.y + part() * box.height()};
    int containing = 0;
    for (const PictureFace& face : picture.faces) containing += is_inside(face, p) ? 1 : 0;
    ASSERT_EQ(containing, 1) << "round " << round << " at " << p.x << ", " << p.y;
  }
}

TEST(ArrangementPicture, FacesTileWhatIsShown) {
  Generator random(11);
  for (int round = 0; round < 600; ++round) {
    const LinearArrangement lines = arrangement(random, round);
    const PlanarPicture picture = picture_of(lines);
    expect_tiles(picture, random, round);
  }
}

TEST(ArrangementPicture, FacesOfCirclesTileThePlane) {
  Generator random(14);
  for (int round = 0; round < 150; ++round) {
    CircularFamily family;
    PieceList<CircularFamily> list;
    const auto pick = [&] { return static_cast<double>(random() % 6); };
    for (int i = 0; i < round % 7; ++i) {
      const Point2 a{pick(), pick()};
      const Point2 b{pick(), pick()};
      if (i % 3 < 2)
        family.add_circle(list, a, 1 + pick());
      else if (a != b)
        family.add_segment(list, a, b);
    }
    const CircularArrangement circles = arrange(std::move(family), list, Context());
    const PlanarPicture picture = picture_of(circles);
    ASSERT_EQ(picture.faces.size(), circles.counts().faces);
    expect_tiles(picture, random, round);
  }
}

TEST(ArrangementPicture, CellsOfADecompositionTileThePlane) {
  Generator random(15);
  for (int round = 0; round < 300; ++round) {
    const LinearArrangement lines = arrangement(random, round);
    for (const bool walls_at_crossings : {true, false}) {
      const VerticalDecomposition decomposition = decompose_vertically(lines, {walls_at_crossings}, Context());
      const PlanarPicture picture = picture_of(lines, decomposition);
      expect_tiles(picture, random, round);
    }
  }
}

TEST(ArrangementPicture, HasEveryRealCellAndSaysWhatItIs) {
  Generator random(12);
  for (int round = 0; round < 200; ++round) {
    const LinearArrangement lines = arrangement(random, round);
    const dcel::Counts counts = lines.counts();
    const PlanarPicture picture = picture_of(lines);
    ASSERT_EQ(picture.faces.size(), counts.faces);
    ASSERT_EQ(picture.edges.size(), counts.edges);
    ASSERT_EQ(picture.points.size(), counts.vertices);
    for (const PictureFace& face : picture.faces) {
      const bool is_unbounded = face.text.facts[0].second == "unbounded";
      ASSERT_EQ(is_unbounded, face.fill.is_none());
    }
  }
}

TEST(ArrangementPicture, NeighboursDifferInColour) {
  Generator random(13);
  for (int round = 0; round < 300; ++round) {
    const LinearArrangement lines = arrangement(random, round);
    const dcel::Dcel& cells = lines.cells();
    const std::vector<std::uint32_t> colors = colors_by_neighbours(cells);
    for (std::size_t e = 0; e < cells.edges.size(); ++e) {
      const dcel::HalfedgeId h(dcel::EdgeId(e), false);
      const dcel::FaceId a = cells.face(h);
      const dcel::FaceId b = cells.face(h.twin());
      if (!cells.is_real(dcel::EdgeId(e)) || a == b || cells[a].is_unbounded || cells[b].is_unbounded) continue;
      ASSERT_NE(colors[a.index()], colors[b.index()]) << round;
    }
  }
}

TEST(ArrangementPicture, CallersSayHowCellsLook) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_polyline(list, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, true);
  family.add_polyline(list, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}, true);
  const LinearArrangement squares = arrange(std::move(family), list, Context());
  ArrangementPictureOptions options;
  options.face = [&](dcel::FaceId f) -> CellLook {
    return {
        {static_cast<std::uint32_t>(f.index()), {}}, {"", "cover " + std::to_string(f.index()), {{"Depth", "1"}}}, {}};
  };
  options.edge = [](dcel::EdgeId) -> CellLook { return {{}, {"Wall", "", {}}, EdgeStyle::strong}; };
  options.curve_name = [](CurveId curve) { return curve.index() == 0 ? "outer" : "inner"; };
  const PlanarPicture picture = picture_of(squares, options);
  ASSERT_EQ(picture.faces.size(), 3U);
  EXPECT_EQ(picture.faces[1].text.label, "cover 1");
  EXPECT_EQ(picture.faces[1].text.name, "Face 1");
  EXPECT_EQ(picture.faces[1].rings.size(), 2U);
  const std::vector<ViewFact> facts{
      {"Depth", "1"}, {"Kind", "bounded"}, {"Edges around", "8"}, {"Holes", "1"}, {"Curves", "outer, inner"}};
  EXPECT_EQ(picture.faces[1].text.facts, facts);
  EXPECT_EQ(picture.edges[0].text.name, "Wall");
  EXPECT_EQ(picture.edges[0].style, EdgeStyle::strong);
  std::ostringstream svg;
  write_svg(svg, picture);
  EXPECT_NE(svg.str().find(">cover 1</text>"), std::string::npos);
}

TEST(ArrangementPicture, StrayCrossingsDoNotShrinkTheRest) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  for (int i = 0; i < 8; ++i) {
    family.add_line(list, {0, static_cast<double>(i)}, {1, i + 1e-9 * i}, "nearly level");
    family.add_line(list, {static_cast<double>(i), 0}, {i + 0.3, 1}, "steep");
  }
  const PlanarPicture picture = picture_of(arrange(std::move(family), list, Context()));
  EXPECT_LT(shown_box(picture).width(), 100);
  EXPECT_GT(shown_box(picture).width(), 8);
}

TEST(FacePole, IsInsideWithRoom) {
  const std::vector<Point2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  const PictureBox box{{-100, -100}, {100, 100}};
  const Pole middle = pole_of({square}, box, 0.01);
  EXPECT_NEAR(middle.radius, 5, 0.02);
  const Pole beside = pole_of({square, {{2, 2}, {8, 2}, {8, 8}, {2, 8}}}, box, 0.01);
  EXPECT_NEAR(beside.radius, 2 / (1 + std::sqrt(0.5)), 0.02)
      << "in a corner, between two sides and a corner of the hole";
  const Pole cut = pole_of({square}, {{-100, -100}, {4, 100}}, 0.01);
  EXPECT_NEAR(cut.radius, 2, 0.02);
  EXPECT_LE(pole_of({}, box, 0.01).radius, 0);
  EXPECT_LE(pole_of({{{0, 0}, {1, 1}}}, box, 0.01).radius, 0);
}

}  // namespace
}  // namespace quoin
