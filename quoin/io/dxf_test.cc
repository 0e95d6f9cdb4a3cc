// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "quoin/io/test_drawings.h"

namespace quoin {
namespace {

using testing::context;
using testing::error_of;

// Groups as "code value" lines.
std::string groups(const std::string& lines) {
  std::string text;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    std::string line = lines.substr(begin, end - begin);
    if (const std::size_t space = line.find(' '); space != std::string::npos) line[space] = '\n';
    text += line + "\r\n";
    begin = end + 1;
  }
  return text;
}

std::string file_of(const std::string& entities) {
  return groups("0 SECTION\n2 ENTITIES\n" + entities + "0 ENDSEC\n0 EOF\n");
}

Drawing dxf(const std::string& text, bool closed_paths_are_polygons = true) {
  return read_drawing(text, "a.dxf", {.format = {}, .closed_paths_are_polygons = closed_paths_are_polygons}, context);
}

std::string refusal(const std::string& text) {
  return error_of([&] { (void)dxf(text); });
}

constexpr const char* square =
    "0 LWPOLYLINE\n8 WALLS\n100 AcDbPolyline\n90 4\n70 1\n10 0\n20 0\n10 4\n20 0\n42 1\n10 4\n20 4\n10 0\n20 4\n";

TEST(Dxf, Entities) {
  const Drawing drawing = dxf(file_of(std::string("0 LINE\n8 0\n10 1\n20 2\n30 0\n11 3\n21 4\n31 0\n") + square +
                                      "0 POLYLINE\n8 OLD\n66 1\n10 0\n20 0\n30 0\n70 0\n0 VERTEX\n10 0\n20 0\n42 0.5\n"
                                      "0 VERTEX\n10 1\n20 1\n42 9\n0 SEQEND\n8 OLD\n"
                                      "0 CIRCLE\n10 1\n20 2\n40 3\n0 POINT\n10 5\n20 6\n30 7\n"
                                      "0 TEXT\n8 0\n1 hello\n0 TEXT\n1 0\n0 INSERT\n2 block\n"));
  ASSERT_EQ(drawing.elements.size(), 5U);
  EXPECT_EQ(drawing.elements[0], (DrawingElement{DrawingPath{{{1, 2}, {3, 4}}, {}, false}, "entity 1", ""}));
  const DrawingPath ring{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0, 1, 0, 0}, true};
  EXPECT_EQ(drawing.elements[1],
            (DrawingElement{DrawingPolygon{{ring}, FillRule::even_odd}, "layer WALLS entity 2", "WALLS"}));
  EXPECT_EQ(drawing.elements[2],
            (DrawingElement{DrawingPath{{{0, 0}, {1, 1}}, {0.5}, false}, "layer OLD entity 3", "OLD"}));
  EXPECT_EQ(drawing.elements[3], (DrawingElement{DrawingCircle{{1, 2}, 3}, "entity 4", ""}));
  EXPECT_EQ(drawing.elements[4], (DrawingElement{Point2{5, 6}, "entity 5", ""}));
  EXPECT_EQ(drawing.notes, (std::vector<std::string>{"entities lose their Z: 1 (entity 5)",
                                                     "entities 'TEXT' are not read: 2 (first entity 6)",
                                                     "entities 'INSERT' are not read: 1 (entity 8)"}));
  EXPECT_EQ(std::get<DrawingPath>(dxf(file_of(square), false).elements.at(0).shape), ring);
}

TEST(Dxf, Arcs) {
  const auto arc = [](const std::string& angles) { return dxf(file_of("0 ARC\n10 1\n20 2\n40 3\n" + angles)); };
  const Drawing half = arc("50 270\n51 90\n");
  EXPECT_EQ(std::get<DrawingPath>(half.elements.at(0).shape), (DrawingPath{{{1, -1}, {1, 5}}, {1}, false}));
  EXPECT_TRUE(half.notes.empty());
  const Drawing slanted = arc("50 10\n51 100\n");
  EXPECT_EQ(slanted.notes.size(), 1U);
  const auto& path = std::get<DrawingPath>(slanted.elements.at(0).shape);
  EXPECT_NEAR(path.points[0].x, 1 + 3 * std::cos(M_PI / 18), 1e-15);
  EXPECT_NEAR(path.bulges[0], std::sqrt(2) - 1, 1e-15);
  EXPECT_EQ(std::get<DrawingCircle>(arc("50 0\n51 360\n").elements.at(0).shape), (DrawingCircle{{1, 2}, 3}));
}

TEST(Dxf, EntitiesSeenFromBelowAreMirrored) {
  const std::string below = "210 0\n220 0\n230 -1\n";
  const Drawing drawing =
      dxf(file_of(square + below + "0 CIRCLE\n10 1\n20 2\n40 3\n" + below + "0 ARC\n10 1\n20 2\n40 3\n50 270\n51 90\n" +
                  below + "0 POINT\n10 1\n20 2\n" + below));
  const DrawingPath& ring = std::get<DrawingPolygon>(drawing.elements.at(0).shape).rings[0];
  EXPECT_EQ(ring.points[1], (Point2{-4, 0}));
  EXPECT_EQ(ring.bulges[1], -1);
  EXPECT_EQ(std::get<DrawingCircle>(drawing.elements.at(1).shape).center, (Point2{-1, 2}));
  EXPECT_EQ(std::get<DrawingPath>(drawing.elements.at(2).shape), (DrawingPath{{{-1, -1}, {-1, 5}}, {-1}, false}));
  EXPECT_EQ(std::get<Point2>(drawing.elements.at(3).shape), (Point2{1, 2}));
  EXPECT_EQ(refusal(file_of("0 CIRCLE\n10 1\n20 2\n40 3\n210 1\n220 0\n230 0\n")),
            "a.dxf:6: entity 1: its extrusion direction is not along z");
}

TEST(Dxf, OtherSectionsAreSkippedWithNotes) {
  const Drawing drawing =
      dxf(groups("999 made by hand\n0 SECTION\n2 HEADER\n9 $ACADVER\n1 AC1009\n9 $INSUNITS\n70 4\n"
                 "0 ENDSEC\n0 SECTION\n2 BLOCKS\n0 BLOCK\n0 LINE\n0 ENDBLK\n0 ENDSEC\n0 SECTION\n"
                 "2 ENTITIES\n0 POINT\n67 1\n10 0\n20 0\n0 ENDSEC\n0 EOF\n\n"));
  EXPECT_TRUE(drawing.elements.empty());
  EXPECT_EQ(drawing.notes, (std::vector<std::string>{"the file's unit ($INSUNITS 4) is not kept: 1",
                                                     "entities of the paper space are not read: 1 (entity 1)"}));
}

TEST(Dxf, RefusalsNameLineAndElement) {
  EXPECT_EQ(refusal("0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n1\n"), "a.dxf:8: the file ends before EOF");
  EXPECT_EQ(refusal("zero\n"), "a.dxf:1: 'zero' is no group code");
  EXPECT_EQ(refusal("AutoCAD Binary DXF\r\n"), "a.dxf:1: binary DXF is not read");
  EXPECT_EQ(refusal(file_of("0 POINT\n8 L\n10 1\n20 1e999\n")),
            "a.dxf:12: layer L entity 1: '1e999' (group 20) is not a finite number");
  EXPECT_EQ(refusal(file_of("0 POINT\n10 nan\n20 1\n")), "a.dxf:8: entity 1: 'nan' (group 10) is not a finite number");
  EXPECT_EQ(refusal(file_of("0 POINT\n10 1\n")), "a.dxf:10: entity 1: a y (group 20) is missing");
  EXPECT_EQ(refusal(file_of("0 POINT\n")), "a.dxf:6: entity 1: its point (groups 10 and 20) is missing");
  EXPECT_EQ(refusal(file_of("0 LINE\n10 1\n20 1\n11 3\n")), "a.dxf:6: entity 1: its end (groups 11 and 21) is missing");
  EXPECT_EQ(refusal(file_of("0 CIRCLE\n10 1\n20 1\n")), "a.dxf:6: entity 1: its radius (group 40) is missing");
  EXPECT_EQ(refusal(file_of("0 LWPOLYLINE\n90 2\n70 0\n10 1\n20 1\n")),
            "a.dxf:6: entity 1: 1 vertices where 2 are announced (group 90)");
  EXPECT_EQ(refusal(file_of("0 LWPOLYLINE\n70 0\n10 1\n20 1\n")), "a.dxf:6: entity 1: it has too few vertices");
  EXPECT_EQ(refusal(file_of("0 VERTEX\n10 1\n20 1\n")), "a.dxf:6: entity 1: 'VERTEX' is outside of a POLYLINE");
  EXPECT_EQ(refusal(file_of("0 POLYLINE\n70 0\n0 VERTEX\n10 1\n20 1\n0 LINE\n")),
            "a.dxf:16: entity 1: VERTEX or SEQEND should stand here");
  EXPECT_EQ(refusal(file_of("0 POLYLINE\n70 16\n0 SEQEND\n")),
            "a.dxf:6: entity 1: polylines that are fitted curves, meshes or surfaces are not supported");
  EXPECT_EQ(refusal(file_of("") + "junk\n"), "a.dxf:9: nothing should follow EOF");
  EXPECT_EQ(refusal(groups("0 SECTION\n2 TABLES\n0 EOF\n")), "a.dxf:6: the section 'TABLES' does not end");
  EXPECT_EQ(refusal(groups("0 LINE\n")), "a.dxf:2: a SECTION or EOF should stand here");
}

// Numbers that are out of range for the parser are zero or refused by their size, not by their looks.
TEST(Dxf, NumbersOutOfRange) {
  const auto x = [](const std::string& number) {
    return std::get<Point2>(dxf(file_of("0 POINT\n10 " + number + "\n20 0\n")).elements.at(0).shape).x;
  };
  EXPECT_EQ(x("1e-400"), 0);
  EXPECT_EQ(x("+1.5E+1"), 15);
  EXPECT_EQ(x("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(x("0." + std::string(400, '0') + "1e401"), 1);
  EXPECT_EQ(x("1" + std::string(400, '0') + "e-400"), 1);
  EXPECT_NE(refusal(file_of("0 POINT\n10 1" + std::string(400, '0') + "e-10\n20 0\n")), "");
}

}  // namespace
}  // namespace quoin
