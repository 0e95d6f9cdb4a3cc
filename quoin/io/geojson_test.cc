// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sstream>

#include "quoin/io/test_drawings.h"

namespace quoin {
namespace {

using testing::context;
using testing::error_of;

Drawing geojson(const std::string& text) {
  return read_drawing(text, "a.geojson", {}, context);
}

std::string refusal(const std::string& text) {
  return error_of([&] { (void)geojson(text); });
}

constexpr const char* collection = R"({
  "type": "FeatureCollection", "crs": {},
  "features": [
    {"type": "Feature", "id": 7, "properties": null, "geometry": {"type": "Point", "coordinates": [1, 2, 3]}},
    {"type": "Feature", "id": "x", "properties": {"name": "Lake", "layer": "WATER", "depth": 3},
     "geometry": {"type": "MultiPolygon", "coordinates": [[[[0,0],[4,0],[4,4],[0,0]],[[2,1],[3,1],[3,2],[2,1]]]]}},
    {"type": "Feature", "properties": {}, "geometry": null},
    {"type": "Feature", "properties": {}, "geometry": {"type": "GeometryCollection", "geometries": [
      {"type": "LineString", "coordinates": [[0, 0], [0.1, 1e3]]}, {"type": "MultiPoint", "coordinates": []}]}}
  ]})";

TEST(GeoJson, FeaturesAreNamed) {
  const Drawing drawing = geojson(collection);
  ASSERT_EQ(drawing.elements.size(), 3U);
  EXPECT_EQ(drawing.elements[0], (DrawingElement{Point2{1, 2}, "7", ""}));
  EXPECT_EQ(drawing.elements[1].name, "Lake, polygon 1");
  EXPECT_EQ(drawing.elements[1].layer, "WATER");
  EXPECT_EQ(std::get<DrawingPolygon>(drawing.elements[1].shape).rings.size(), 2U);
  EXPECT_EQ(drawing.elements[2],
            (DrawingElement{DrawingPath{{{0, 0}, {0.1, 1000}}, {}, false}, "feature 4, linestring 1", ""}));
  EXPECT_EQ(drawing.notes, (std::vector<std::string>{"reference systems (crs) are not kept: 1",
                                                     "positions lose what goes beyond x and y: 1 (7)",
                                                     "properties other than name and layer are not kept: 1 (feature 2)",
                                                     "features without geometry add nothing: 1 (feature 3)",
                                                     "empty geometries add nothing: 1 (feature 4, geometry 2)"}));
  EXPECT_EQ(geojson(R"({"type":"Point","coordinates":[-0.0,9007199254740993]})").elements[0],
            (DrawingElement{Point2{0, 9007199254740992}, "point 1", ""}));
}

TEST(GeoJson, RefusalsNameLineAndElement) {
  const auto polygon = [](const std::string& rings) {
    return "{\"type\":\"Feature\",\n\"properties\":{},\"geometry\":{\"type\":\"Polygon\",\n\"coordinates\":[" + rings +
           "]}}";
  };
  EXPECT_EQ(refusal(polygon("[[0,0],[4,0],[4,4],[0,0]],\n[[0,0],[1,0],[1,1]]")),
            "a.geojson:4: feature 1, ring 2: the ring is not closed: its last position is not its first");
  EXPECT_EQ(refusal(polygon("[[0,0],[4,0],[0,0]]")), "a.geojson:3: feature 1, ring 1: the ring has too few positions");
  EXPECT_EQ(refusal(polygon("[[0,0],\n[4,0],\n[4,\"4\"],[0,0]]")),
            "a.geojson:5: feature 1, ring 1: a coordinate is no number");
  EXPECT_EQ(refusal(polygon("[[0,0],\n[4]]")),
            "a.geojson:4: feature 1, ring 1: a position is an array of two to four numbers");
  EXPECT_EQ(refusal(polygon("[0,0]")), "a.geojson:3: feature 1, ring 1: a position is an array of two to four numbers");
  EXPECT_EQ(refusal("{\"type\":\n\"Circle\",\n\"coordinates\":[]}"),
            "a.geojson:1: geometry 1: 'Circle' is no type of geometry");
  EXPECT_EQ(refusal("{\n}"), "a.geojson:1: 'type' is missing");
  EXPECT_EQ(refusal(R"({"type":"FeatureCollection","features":[{"type":"Point"}]})"),
            "a.geojson:1: feature 1: it is no Feature");
  EXPECT_EQ(refusal(R"({"type":"LineString","coordinates":[[0,0]]})"),
            "a.geojson:1: linestring 1: a LineString has at least two positions");
  EXPECT_NE(
      refusal("{\"type\":\"Point\",\n\"coordinates\":[1,1e999]}").find("a.geojson:2: not JSON that can be read: "),
      std::string::npos);
  EXPECT_NE(refusal("{\"type\":\"Point\",\n\"coordinates\":[1,NaN]}").find("a.geojson:2: "), std::string::npos);
  EXPECT_NE(refusal(R"({"type":"Point","coordinates":[1,2]} x)").find("a.geojson:1: not JSON"), std::string::npos);
}

TEST(GeoJson, DeepNestingIsRefused) {
  EXPECT_EQ(refusal(std::string(1'000'000, '[')), "a.geojson:1: arrays and objects are nested too deeply");
}

TEST(GeoJson, ArcsAreRefusedOrFlattened) {
  Drawing drawing;
  drawing.elements.push_back({DrawingCircle{{1, 2}, 3}, "round", ""});
  drawing.elements.push_back({DrawingPath{{{0, 0}, {1, 0}}, {-5}, false}, "keyhole", ""});
  std::ostringstream out;
  EXPECT_EQ(error_of([&] { write_drawing(out, DrawingFormat::geojson, drawing, {}, context); }),
            "round: GeoJSON has no arcs; they can be flattened within a tolerance");
  for (const double tolerance : {1.0, 0.1, 1e-3, 1e-6}) {
    out.str("");
    const auto notes = write_drawing(out, DrawingFormat::geojson, drawing, {.flatten_tolerance = tolerance}, context);
    EXPECT_EQ(notes.size(), 1U);
    const Drawing again = geojson(out.str());
    const auto& chain = std::get<DrawingPath>(again.elements.at(0).shape);
    EXPECT_TRUE(chain.is_closed);
    for (std::size_t e = 0; e < chain.edge_count(); ++e) {
      const Point2 a = chain.start(e);
      const Point2 b = chain.end(e);
      EXPECT_NEAR(std::hypot(a.x - 1, a.y - 2), 3, 1e-14);
      EXPECT_GE(std::hypot((a.x + b.x) / 2 - 1, (a.y + b.y) / 2 - 2), 3 - tolerance - 1e-14);
    }
    // Bulge -5 over [0, 1]: radius (1/5 + 5) / 4 = 1.3 about (0.5, 1.2), the arc above.
    const auto& hole = std::get<DrawingPath>(again.elements.at(1).shape);
    double top = 0;
    for (const Point2& p : hole.points) {
      EXPECT_NEAR(std::hypot(p.x - 0.5, p.y - 1.2), 1.3, 1e-14);
      top = std::max(top, p.y);
    }
    EXPECT_NEAR(top, 2.5, tolerance);
  }
  for (const double tolerance : {0.0, -1.0, std::nan(""), 1e-300})
    EXPECT_NE(error_of([&] {
                write_drawing(out, DrawingFormat::geojson, drawing, {.flatten_tolerance = tolerance}, context);
              }),
              "");
}

TEST(GeoJson, NamesThatAreNotUtf8AreRefused) {
  Drawing drawing;
  drawing.elements.push_back({Point2{1, 2}, "\xFF", ""});
  std::ostringstream out;
  EXPECT_THROW(write_drawing(out, DrawingFormat::geojson, drawing, {}, context), InputError);
}

TEST(GeoJson, NothingIsACollectionToo) {
  std::vector<std::string> notes;
  const std::string text = testing::written(DrawingFormat::geojson, {}, notes);
  EXPECT_EQ(text, "{\"type\":\"FeatureCollection\",\"features\":[\n]}\n");
  EXPECT_TRUE(read_drawing(text, "a.geojson", {}, testing::context).elements.empty());
}

}  // namespace
}  // namespace quoin
