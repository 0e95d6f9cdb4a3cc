// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "quoin/arrangement/circular/circular_exact.h"
#include "quoin/arrangement/circular/circular_family.h"
#include "quoin/arrangement/circular/circular_shapes.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin {
namespace {

using Direction = CircularFamily::Direction;

/// Ends of a piece in the direction of its curve.
std::uint32_t start_of(const Piece& piece) {
  return piece.reversed ? piece.right : piece.left;
}
std::uint32_t end_of(const Piece& piece) {
  return piece.reversed ? piece.left : piece.right;
}

TEST(CircularInput, CircleIsTwoHalves) {
  CircularFamily family;
  CircularFamily::Pieces list;
  const CurveId curve = family.add_circle(list, Point2{3, -2}, 5);
  ASSERT_EQ(list.pieces.size(), 2U);
  EXPECT_EQ(list.pieces[0].branch, CircularFamily::lower_half(CircularSupportId(0)));
  EXPECT_FALSE(list.pieces[0].reversed);
  EXPECT_TRUE(list.pieces[1].reversed);
  EXPECT_EQ(list.pieces[0].left, list.pieces[1].left);
  EXPECT_EQ(list.pieces[0].right, list.pieces[1].right);
  EXPECT_EQ(list.pieces[1].curve, curve);
  EXPECT_EQ(family.position(list.points[list.pieces[0].left]), (Point2{-2, -2}));
  EXPECT_EQ(list.points[list.pieces[0].right].kind, CircularPointKind::doubles);
}

/// All arcs between lattice points of two circles: a connected walk from start to end, with the right total angle.
TEST(CircularInput, ArcsWalkFromStartToEnd) {
  for (const int square : {25, 5}) {
    std::vector<Point2> on;
    for (int x = -5; x <= 5; ++x) {
      for (int y = -5; y <= 5; ++y) {
        if (x * x + y * y == square) on.push_back({7.0 + x, 1.0 + y});
      }
    }
    const RationalCircle circle{7, 1, square};
    for (const Point2& from : on) {
      for (const Point2& to : on) {
        for (const Direction direction : {Direction::counterclockwise, Direction::clockwise}) {
          if (from == to) continue;
          CircularFamily family;
          CircularFamily::Pieces list;
          family.add_arc(list, circle, RationalPoint2{from.x, from.y}, RationalPoint2{to.x, to.y}, direction);
          std::vector<Piece> walk = list.pieces;
          if (direction == Direction::clockwise) walk.assign(list.pieces.rbegin(), list.pieces.rend());
          EXPECT_EQ(family.position(list.points[start_of(walk.front())]), from);
          EXPECT_EQ(family.position(list.points[end_of(walk.back())]), to);
          double length = 0;
          for (std::size_t i = 0; i < walk.size(); ++i) {
            if (i > 0) {
              EXPECT_EQ(start_of(walk[i]), end_of(walk[i - 1]));
            }
            EXPECT_EQ(family.compare_xy(list.points[walk[i].left], list.points[walk[i].right]), Sign::negative);
            const std::vector<Point2> chain =
                flatten(family, walk[i].branch, list.points[walk[i].left], list.points[walk[i].right], 1e-7);
            for (std::size_t k = 1; k < chain.size(); ++k) {
              length += std::hypot(chain[k].x - chain[k - 1].x, chain[k].y - chain[k - 1].y);
            }
          }
          double angle = std::atan2(to.y - 1, to.x - 7) - std::atan2(from.y - 1, from.x - 7);
          if (direction == Direction::clockwise) angle = -angle;
          if (angle < 0) angle += 2 * std::numbers::pi;
          EXPECT_NEAR(length, angle * std::sqrt(square), 1e-5);
        }
      }
    }
  }
}

TEST(CircularInput, BulgeIsTwiceTheSagittaOverTheChord) {
  for (const double bulge : {1.0, -1.0, 0.5, -0.25, 0.3, -0.7, 1e-3}) {
    CircularFamily family;
    CircularFamily::Pieces list;
    const Point2 from{1, 2};
    const Point2 to{4, 6};
    family.add_bulge_arc(list, from, to, bulge);
    // Counterclockwise arcs lie to the right of their chord, at half the bulge times the chord.
    const Point2 top{2.5 + 0.5 * bulge * 4, 4 - 0.5 * bulge * 3};
    double distance = 1;
    for (const Piece& piece : list.pieces) {
      const CircularPoint& left = list.points[piece.left];
      const CircularPoint& right = list.points[piece.right];
      const std::vector<Point2> chain = flatten(family, piece.branch, left, right, 1e-9);
      for (std::size_t k = 1; k < chain.size(); ++k) {
        const Vector2 edge{chain[k].x - chain[k - 1].x, chain[k].y - chain[k - 1].y};
        const Vector2 to_top{top.x - chain[k - 1].x, top.y - chain[k - 1].y};
        const double t =
            std::clamp((edge.x * to_top.x + edge.y * to_top.y) / (edge.x * edge.x + edge.y * edge.y), 0., 1.);
        distance = std::min(distance, std::hypot(to_top.x - t * edge.x, to_top.y - t * edge.y));
      }
    }
    EXPECT_LT(distance, 2e-9) << bulge;
    const std::size_t last = list.pieces.size() - 1;
    EXPECT_EQ(family.position(list.points[start_of(list.pieces[bulge > 0 ? 0 : last])]), from);
    EXPECT_EQ(family.position(list.points[end_of(list.pieces[bulge > 0 ? last : 0])]), to);
  }
}

TEST(CircularInput, RefusesWhatIsNoCurveAndNamesIt) {
  using Action = std::function<void(CircularFamily&, CircularFamily::Pieces&)>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Action> actions = {
      [](auto& f, auto& l) {
        f.add_circle(l, Point2{0, 0}, 0, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_circle(l, Point2{0, 0}, -1, "curve 7");
      },
      [&](auto& f, auto& l) {
        f.add_circle(l, Point2{0, 0}, nan, "curve 7");
      },
      [&](auto& f, auto& l) {
        f.add_circle(l, Point2{nan, 0}, 1, "curve 7");
      },
      [&](auto& f, auto& l) {
        f.add_circle(l, Point2{0, infinity}, 1, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_circle(l, Point2{0, 1e100}, 1, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_circle(l, Point2{0, 1e-300}, 1, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_circle(l, Point2{0, 0}, 1e-300, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_circle(l, RationalCircle{0, 0, 0}, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_circle(l, RationalCircle{0, 0, -3}, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_segment(l, Point2{1, 2}, Point2{1, 2}, "curve 7");
      },
      [&](auto& f, auto& l) {
        f.add_segment(l, Point2{1, 2}, Point2{1, nan}, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_segment(l, RationalPoint2{1, 2}, RationalPoint2{1, 2}, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_arc(l, Point2{0, 0}, 5, Point2{3, 4}, Point2{3, 4.5}, Direction::clockwise, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_arc(l, Point2{0, 0}, 5, Point2{3, 3}, Point2{3, 4}, Direction::clockwise, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_arc(l, Point2{0, 0}, 5, Point2{3, 4}, Point2{3, 4}, Direction::clockwise, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_bulge_arc(l, Point2{3, 4}, Point2{3, 4}, 1, "curve 7");
      },
      [&](auto& f, auto& l) {
        f.add_bulge_arc(l, Point2{3, 4}, Point2{3, 5}, nan, "curve 7");
      },
      [](auto& f, auto& l) {
        f.add_bulge_arc(l, Point2{3, 4}, Point2{3, 5}, 1e-70, "curve 7");
      },
      [&](auto& f, auto& l) {
        f.add_point(l, Point2{3, infinity}, "curve 7");
      },
  };
  for (std::size_t i = 0; i < actions.size(); ++i) {
    CircularFamily family;
    CircularFamily::Pieces list;
    try {
      actions[i](family, list);
      ADD_FAILURE() << "action " << i << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("curve 7: ", 0), 0U) << error.what();
    }
    EXPECT_TRUE(list.pieces.empty() && list.points.empty() && list.lone_points.empty());
    EXPECT_EQ(list.curve_count, 0U);
  }
}

TEST(CircularShapes, AreasAndBoxesContainTheTruth) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> real(0, 4);
  for (int i = 0; i < test_rounds(300); ++i) {
    CircularFamily family;
    CircularFamily::Pieces list;
    const double r = 0.1 + real(random);
    family.add_circle(list, Point2{real(random), real(random)}, r);
    family.add_bulge_arc(list, Point2{real(random), real(random)}, Point2{real(random), real(random)},
                         real(random) - 2);
    family.add_segment(list, Point2{real(random), real(random)}, Point2{real(random), real(random)});
    double area = 0;
    double error = 0;
    for (const Piece& piece : list.pieces) {
      const CircularPoint& left = list.points[piece.left];
      const CircularPoint& right = list.points[piece.right];
      const CertifiedDouble under = area_under(family, piece.branch, left, right);
      const std::vector<Point2> chain = flatten(family, piece.branch, left, right, 1e-8);
      double sum = 0;
      double width = 0;
      for (std::size_t k = 1; k < chain.size(); ++k) {
        sum += 0.5 * (chain[k].x - chain[k - 1].x) * (chain[k].y + chain[k - 1].y);
        width += std::hypot(chain[k].x - chain[k - 1].x, chain[k].y - chain[k - 1].y);
      }
      ASSERT_NEAR(sum, under.value, under.error + 2e-8 * width);
      const Box2 around = box(family, piece.branch, left, right);
      for (const Point2& p : chain) ASSERT_TRUE(around.contains(p));
      ASSERT_TRUE(around.contains(arc_midpoint(family, piece.branch, left, right)));
      if (piece.curve == CurveId(0)) {
        area += piece.reversed ? under.value : -under.value;
        error += under.error;
      }
    }
    ASSERT_NEAR(area, std::numbers::pi * r * r, error);
    ASSERT_LT(error, 1e-10);
  }
}

TEST(CircularShapes, ExactCoordinatesAndBounds) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 200; ++i) {
    CircularFamily family;
    const auto pick = [&] { return static_cast<double>(random() % 7); };
    const CircularSupportId a = family.add_circle_support(RationalCircle{
        Rational(Integer(static_cast<int>(random() % 9)), Integer(3)), pick(), 1 + static_cast<int>(random() % 9)});
    const CircularSupportId b = random() % 2 == 0
                                    ? family.add_circle_support(Point2{pick(), pick() + 0.5}, 1 + pick())
                                    : family.add_line_support(Point2{pick(), pick()}, Point2{7 + pick(), pick()});
    CircularPoint points[2];
    const int count = family.crossings(a, b, points);
    for (int k = 0; k < count; ++k) {
      const OneRootPoint exact = exact_coordinates(family, points[k]);
      for (const std::size_t bits : {10U, 60U, 200U}) {
        const RationalBounds x = bounds_of(exact.ax, exact.bx, exact.c, bits);
        const RationalBounds y = bounds_of(exact.ay, exact.by, exact.c, bits);
        const Rational error(family.error());
        ASSERT_LE(x.low, x.high);
        ASSERT_LE(x.low - error, Rational(points[k].x));
        ASSERT_GE(x.high + error, Rational(points[k].x));
        ASSERT_LE(y.low - error, Rational(points[k].y));
        ASSERT_GE(y.high + error, Rational(points[k].y));
        ASSERT_LE(x.high - x.low, abs(exact.bx) * Rational(std::ldexp(1.0, -static_cast<int>(bits))));
      }
      const RationalCircle circle = family.circle(a);
      // (x - cx)^2 + (y - cy)^2 = r^2, rational part and factor of the root.
      const Rational dx = exact.ax - circle.x;
      const Rational dy = exact.ay - circle.y;
      ASSERT_EQ(dx * dx + dy * dy + (exact.bx * exact.bx + exact.by * exact.by) * exact.c, circle.squared_radius);
      ASSERT_EQ((dx * exact.bx + dy * exact.by).sign() == Sign::zero || exact.c.sign() == Sign::zero, true);
    }
  }
}

TEST(CircularFamilyFilters, DecideRandomInput) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> real(0, 1);
  CircularFamily family;
  for (int i = 0; i < 300; ++i) {
    const Point2 p{real(random), real(random)};
    family.add_circle_support(p, 0.01 + 0.25 * real(random));
  }
  const circular_exact::Counts before = circular_exact::counts();
  std::vector<CircularPoint> points;
  for (std::size_t i = 0; i < 300; ++i) {
    for (std::size_t j = i + 1; j < 300; ++j) {
      CircularPoint found[2];
      const int count = family.crossings(CircularSupportId(i), CircularSupportId(j), found);
      points.insert(points.end(), found, found + count);
    }
  }
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_NE(family.compare_xy(points[i - 1], points[i]), Sign::zero);
  const circular_exact::Counts& after = circular_exact::counts();
  const std::uint64_t exact = after.narrow + after.wide + after.big - before.narrow - before.wide - before.big;
  EXPECT_GT(points.size(), 10000U);
  EXPECT_LT(exact, points.size() / 50);
}

TEST(CircularFamilyFilters, QueriesMayBeTinyOrHuge) {
  CircularFamily family;
  const BranchId line = CircularFamily::line_branch(family.add_line_support(Point2{-1, 0}, Point2{1, 0}));
  const BranchId slope = CircularFamily::line_branch(family.add_line_support(Point2{-1, -1}, Point2{1, 1}));
  const CircularSupportId circle = family.add_circle_support(Point2{0, 0}, 1);
  const double tiny = std::numeric_limits<double>::denorm_min();
  const auto at = [&](double x, double y, BranchId branch) {
    return family.compare_y_at_x(CircularFamily::query({x, y}), branch);
  };
  EXPECT_EQ(at(0.5, tiny, line), Sign::positive);
  EXPECT_EQ(at(0.5, -tiny, line), Sign::negative);
  EXPECT_EQ(at(tiny, 2 * tiny, slope), Sign::positive);
  EXPECT_EQ(at(tiny, tiny, slope), Sign::zero);
  EXPECT_EQ(at(3 * tiny, 2 * tiny, slope), Sign::negative);
  EXPECT_EQ(at(1, tiny, CircularFamily::upper_half(circle)), Sign::positive);
  EXPECT_EQ(at(1, 0, CircularFamily::upper_half(circle)), Sign::zero);
  EXPECT_EQ(at(tiny, 1, CircularFamily::upper_half(circle)), Sign::positive);
  EXPECT_EQ(at(tiny, 1e300, CircularFamily::upper_half(circle)), Sign::positive);
  EXPECT_EQ(at(0.25, -1e300, CircularFamily::lower_half(circle)), Sign::negative);
}

TEST(CircularFamilyFilters, CrossingsFarOutsideAreExact) {
  CircularFamily family;
  const CircularSupportId a = family.add_line_support(Point2{0, 0}, Point2{1, 0});
  const CircularSupportId b = family.add_line_support(Point2{0, 1}, Point2{1, 1 - 0x1p-40});
  const CircularSupportId c = family.add_line_support(Point2{0, 1}, Point2{1, 1 - 0x1p-41});
  CircularPoint ab;
  CircularPoint ac;
  ASSERT_EQ(family.crossings(a, b, &ab), 1);
  ASSERT_EQ(family.crossings(a, c, &ac), 1);
  EXPECT_EQ(family.position(ab), (Point2{0x1p40, 0}));
  EXPECT_EQ(family.compare_xy(ab, ac), Sign::negative);
  EXPECT_EQ(family.compare_xy(ab, CircularFamily::query({0x1p40, 0})), Sign::zero);
  EXPECT_EQ(family.compare_xy(ac, CircularFamily::query({1, 0})), Sign::positive);
  EXPECT_EQ(family.compare_y_at_x(ab, CircularFamily::line_branch(c)), Sign::negative);
}

}  // namespace
}  // namespace quoin
