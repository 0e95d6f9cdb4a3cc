// SPDX-License-Identifier: Apache-2.0
//
// What holds for drawings of every format: round trips, damaged texts, checks.
#include "quoin/io/drawing.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "quoin/base/error.h"
#include "quoin/io/mesh_file.h"
#include "quoin/io/test_drawings.h"

namespace quoin {
namespace {

using testing::context;
using testing::error_of;
using testing::Random;
using testing::random_drawing;
using testing::shapes_equal;
using testing::written;

constexpr DrawingFormat formats[] = {DrawingFormat::wkt, DrawingFormat::geojson, DrawingFormat::svg,
                                     DrawingFormat::dxf};
constexpr const char* endings[] = {"a.wkt", "a.geojson", "a.svg", "a.dxf"};

const char* name_of(DrawingFormat format) {
  return endings[static_cast<std::size_t>(format)];
}

Drawing read(DrawingFormat format, const std::string& text) {
  return read_drawing(text, name_of(format), {}, context);
}

// Without notes of the writer the same comes back, whatever the drawing.
TEST(Drawing, WhatIsWrittenWithoutNotesComesBackExactly) {
  Random random(1);
  std::size_t without_notes = 0;
  for (int i = 0; i < 600; ++i) {
    const Drawing drawing = random_drawing(random, {});
    for (const DrawingFormat format : formats) {
      SCOPED_TRACE(name_of(format));
      std::vector<std::string> notes;
      const std::string text = written(format, drawing, notes);
      if (text.empty()) continue;  // refused
      SCOPED_TRACE(text);
      const Drawing again = read(format, text);
      if (!notes.empty()) continue;
      ++without_notes;
      ASSERT_TRUE(shapes_equal(drawing, again));
    }
  }
  EXPECT_GT(without_notes, 300U);
}

// What each format can hold for certain is written without notes.
TEST(Drawing, EachFormatHoldsItsOwn) {
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    for (const DrawingFormat format : formats) {
      SCOPED_TRACE(name_of(format));
      testing::DrawingFamily family;
      family.has_arcs = format == DrawingFormat::dxf;
      family.has_points = format != DrawingFormat::svg;
      family.has_circles = format == DrawingFormat::svg || format == DrawingFormat::dxf;
      family.has_layers = format != DrawingFormat::wkt;
      family.has_closed_paths = format == DrawingFormat::wkt || format == DrawingFormat::geojson;
      family.has_holes = format != DrawingFormat::dxf;
      const Drawing drawing = random_drawing(random, family);
      std::vector<std::string> notes;
      const std::string text = written(format, drawing, notes);
      SCOPED_TRACE(text);
      EXPECT_EQ(notes, std::vector<std::string>{});
      const Drawing again = read(format, text);
      ASSERT_TRUE(shapes_equal(drawing, again));
      if (format == DrawingFormat::geojson) {
        ASSERT_EQ(drawing.elements, again.elements);
      }
      // Names too, once they are the reader's.
      std::vector<std::string> more;
      ASSERT_EQ(read(format, written(format, again, more)).elements, again.elements);
    }
  }
}

TEST(Drawing, CutTextsAreRefusedOrRead) {
  Random random(3);
  for (int i = 0; i < 5; ++i) {
    const Drawing drawing = random_drawing(random, {});
    for (const DrawingFormat format : formats) {
      std::vector<std::string> notes;
      const std::string text = written(format, drawing, notes);
      for (std::size_t size = 0; size < text.size(); ++size) {
        SCOPED_TRACE(text.substr(0, size));
        error_of([&] { (void)read(format, text.substr(0, size)); });
        error_of([&] { (void)read_drawing(text.substr(0, size), "unknown", {}, context); });
      }
      if (format == DrawingFormat::wkt || text.empty()) continue;  // whole geometries may be missing
      const std::size_t last = text.find_last_not_of('\n');
      EXPECT_NE(error_of([&] { (void)read(format, text.substr(0, last)); }), "");
    }
  }
}

TEST(Drawing, DamagedBytesAreRefusedOrRead) {
  Random random(4);
  constexpr std::string_view likely = "()<>[]{},;:\"'/ZMAze.-+0197\n\r \0\xFF=";
  for (int i = 0; i < 6; ++i) {
    const Drawing drawing = random_drawing(random, {});
    for (const DrawingFormat format : formats) {
      std::vector<std::string> notes;
      const std::string whole = written(format, drawing, notes);
      for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string text = whole;
        text[at] = random() % 2 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
        SCOPED_TRACE(text);
        error_of([&] {
          const Drawing damaged = read(format, text);
          check_drawing(damaged);
          std::vector<std::string> more;
          const std::string again = written(format, damaged, more);
          if (!more.empty() || again.empty()) return;
          EXPECT_TRUE(shapes_equal(damaged, read(format, again)));
        });
      }
    }
  }
}

TEST(Drawing, FormatIsToldByOptionEndingOrContent) {
  const std::string dxf = "0\nSECTION\n2\nENTITIES\n0\nPOINT\n10\n1\n20\n2\n0\nENDSEC\n0\nEOF\n";
  EXPECT_EQ(read_drawing(dxf, "-", {}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing("M0 0L1 1", "-", {}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing("<svg><path d='M0 0L1 1'/></svg>", "-", {}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing(R"({"type":"Point","coordinates":[1,2]})", "-", {}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing("POINT(1 2)", "-", {}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing("SRID=4326;POINT(1 2)", "-", {}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing("POINT(1 2)", "a.svg", {.format = DrawingFormat::wkt}, context).elements.size(), 1U);
  EXPECT_EQ(read_drawing("POINT(1 2)", "a.WKT", {}, context).elements.size(), 1U);
  EXPECT_NE(error_of([] { (void)read_drawing("", "-", {}, context); }).find("-:1: neither"), std::string::npos);
}

TEST(Drawing, FilesAreWrittenAndRead) {
  const auto path = std::filesystem::temp_directory_path() / "quoin_drawing_test.dxf";
  Drawing drawing;
  drawing.elements.push_back({DrawingCircle{{0.1, -2}, 1e-3}, "circle 1", "WALLS"});
  EXPECT_TRUE(write_drawing(path, DrawingFormat::dxf, drawing, {}, context).empty());
  EXPECT_TRUE(shapes_equal(read_drawing(path, {}, context), drawing));
  std::filesystem::remove(path);
  EXPECT_THROW((void)read_drawing(path, {}, context), FileError);
  EXPECT_THROW(write_drawing(path, DrawingFormat::geojson, drawing, {}, context), InputError);  // no arcs
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_THROW(write_drawing("/nowhere/a.dxf", DrawingFormat::dxf, drawing, {}, context), FileError);
}

TEST(Drawing, CheckNamesTheElement) {
  const auto check = [](auto shape) {
    Drawing drawing;
    drawing.elements.push_back({Point2{1, 2}, "fine", ""});
    drawing.elements.push_back({std::move(shape), "the culprit", ""});
    return error_of([&] { check_drawing(drawing); });
  };
  EXPECT_EQ(check(DrawingCircle{{0, 0}, 1}), "");
  EXPECT_EQ(check(DrawingCircle{{0, 0}, 0}), "the culprit: the radius 0 is not positive");
  EXPECT_EQ(check(DrawingCircle{{0, 0}, -1}), "the culprit: the radius -1 is not positive");
  EXPECT_EQ(check(DrawingPath{{{0, 0}, {1, 0}, {1, 0}}, {}, false}), "the culprit: edge 2 has zero length at 1 0");
  EXPECT_EQ(check(DrawingPath{{{0, 0}, {1, 0}, {0, 0}}, {}, false}), "");
  EXPECT_EQ(check(DrawingPath{{{3, 0}}, {}, true}), "the culprit: edge 1 has zero length at 3 0");
  EXPECT_EQ(check(DrawingPath{{}, {}, true}), "the culprit: there are no vertices");
  EXPECT_EQ(check(DrawingPath{{{0, 0}, {1, 0}}, {1, 1}, false}), "the culprit: 2 bulges for 1 edges");
  EXPECT_EQ(check(DrawingPath{{{0, 0}, {1, 0}}, {HUGE_VAL}, false}), "the culprit: the bulge of edge 1 is not finite");
  const DrawingPath square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, true};
  const DrawingPath repeated{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, {}, true};
  EXPECT_EQ(check(DrawingPolygon{{square}, FillRule::even_odd}), "");
  EXPECT_EQ(check(DrawingPolygon{{square, repeated}, FillRule::even_odd}),
            "the culprit: ring 2, the last vertex repeats the first at 0 0");
  EXPECT_EQ(check(DrawingPolygon{{DrawingPath{{{0, 0}, {1, 0}}, {}, true}}, FillRule::even_odd}),
            "the culprit: ring 1, the ring has too few vertices");
  EXPECT_EQ(check(DrawingPolygon{{DrawingPath{{{0, 0}, {1, 0}}, {0, 1}, true}}, FillRule::even_odd}), "");
  EXPECT_EQ(check(DrawingPolygon{}), "the culprit: there are no rings");
}

// Time grows with the text: the same test in a quadratic reader takes minutes.
TEST(Drawing, LargeFilesAreReadInLinearTime) {
  Drawing drawing;
  DrawingPath ring;
  ring.is_closed = true;
  for (int i = 0; i < 200'000; ++i)
    ring.points.push_back({static_cast<double>(i) / 7, static_cast<double>(i % 977) / 3});
  drawing.elements.push_back({DrawingPolygon{{ring}, FillRule::even_odd}, "polygon 1", ""});
  for (int i = 0; i < 50'000; ++i)
    drawing.elements.push_back({DrawingPath{{{0.0, 1.0 * i}, {1.0, 2.0 * i}}, {}, false}, "line", ""});
  for (const DrawingFormat format : formats) {
    std::vector<std::string> notes;
    EXPECT_TRUE(shapes_equal(read(format, written(format, drawing, notes)), drawing)) << name_of(format);
  }
}

}  // namespace
}  // namespace quoin
