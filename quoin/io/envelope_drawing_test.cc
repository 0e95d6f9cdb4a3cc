// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/envelope_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "quoin/base/error.h"
#include "quoin/io/drawing_curves.h"

namespace quoin {
namespace {

const DrawingPath& path_of(const Drawing& drawing, std::size_t i) {
  return std::get<DrawingPath>(drawing.elements[i].shape);
}

TEST(EnvelopeDrawing, JoinsWhatIsContinuousAndKeepsPoints) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_polyline(list, {{0, 0}, {4, 4}, {8, 0}});
  family.add_segment(list, Point2{4, 0}, Point2{8, 8});
  family.add_point(list, {1, -1});
  family.add_segment(list, Point2{9, 3}, Point2{9, 2});
  const Drawing drawing = draw_envelope(family, lower_envelope(family, list, Context()));
  ASSERT_EQ(drawing.elements.size(), 5U);
  EXPECT_EQ(path_of(drawing, 0).points, (std::vector<Point2>{{0, 0}, {1, 1}}));
  EXPECT_EQ(std::get<Point2>(drawing.elements[1].shape), (Point2{1, -1}));
  EXPECT_EQ(path_of(drawing, 2).points, (std::vector<Point2>{{1, 1}, {4, 4}}));
  EXPECT_EQ(path_of(drawing, 3).points.front(), (Point2{4, 0}));
  EXPECT_EQ(path_of(drawing, 3).points.back(), (Point2{8, 0}));
  EXPECT_EQ(std::get<Point2>(drawing.elements[4].shape), (Point2{9, 2}));
}

TEST(EnvelopeDrawing, DrawsHalfACircleWithBulgeOne) {
  CircularFamily family;
  PieceList<CircularFamily> list;
  family.add_circle(list, {3, 1}, 2);
  const Drawing upper = draw_envelope(family, upper_envelope(family, list, Context()));
  const Drawing lower = draw_envelope(family, lower_envelope(family, list, Context()));
  ASSERT_EQ(upper.elements.size(), 1U);
  EXPECT_EQ(path_of(upper, 0).points, (std::vector<Point2>{{1, 1}, {5, 1}}));
  EXPECT_EQ(path_of(upper, 0).bulges, std::vector<double>{-1});
  EXPECT_EQ(path_of(lower, 0).bulges, std::vector<double>{1});
}

TEST(EnvelopeDrawing, RefusesWhatReachesInfinity) {
  LinearFamily family;
  PieceList<LinearFamily> list;
  family.add_ray(list, {0, 0}, {1, 1});
  EXPECT_THROW(draw_envelope(family, lower_envelope(family, list, Context())), InputError);
}

TEST(EnvelopeDrawing, IsItsOwnEnvelope) {
  // Segments of slopes -1, 0 and 1 between even points cross in doubles.
  std::mt19937 random(1);
  const auto even = [&](unsigned count) { return 2.0 * static_cast<double>(random() % count); };
  for (int round = 0; round < 200; ++round) {
    LinearFamily family;
    PieceList<LinearFamily> list;
    for (int i = 0; i < 12; ++i) {
      const Point2 a{even(12), even(12)};
      const double length = 2 + even(5);
      const double slope = static_cast<double>(random() % 3) - 1;
      family.add_segment(list, a, Point2{a.x + length, a.y + slope * length});
    }
    const Drawing drawing = draw_envelope(family, lower_envelope(family, list, Context()));
    LinearFamily drawn_family;
    PieceList<LinearFamily> drawn;
    std::vector<std::string> names;
    add_curves(drawn_family, drawn, drawing, names);
    const Drawing again = draw_envelope(drawn_family, lower_envelope(drawn_family, drawn, Context()));
    ASSERT_EQ(again.elements, drawing.elements) << "round " << round;
  }
}

TEST(EnvelopeDrawing, EndsIntervalsOnTheirCurves) {
  std::mt19937 random(2);
  const auto pick = [&] { return static_cast<double>(random() % 1000) / 100; };
  for (int round = 0; round < 100; ++round) {
    CircularFamily family;
    PieceList<CircularFamily> list;
    for (int i = 0; i < 8; ++i) {
      family.add_circle(list, {pick(), pick()}, 0.5 + pick() / 5);
      const Point2 a{pick(), pick()};
      family.add_segment(list, a, Point2{a.x + 1, pick()});
    }
    const CircularEnvelope envelope = upper_envelope(family, list, Context());
    for (std::size_t i = 0; i < envelope.interval_count(); ++i) {
      if (envelope.is_gap(i)) continue;
      for (const std::optional<Point2>& end : {left_end(family, envelope, i), right_end(family, envelope, i)}) {
        ASSERT_TRUE(end.has_value());
        const CircularSupport& support = family.rounded(CircularFamily::support(envelope.branch(i)));
        const double off = support.is_line() ? (end->x - support.x) * support.dy - (end->y - support.y) * support.dx
                                             : std::hypot(end->x - support.x, end->y - support.y) - support.radius;
        ASSERT_LT(std::fabs(off), 1e-11);
      }
    }
  }
}

}  // namespace
}  // namespace quoin
