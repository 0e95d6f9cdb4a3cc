// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "quoin/arrangement/geodesic/geodesic_family.h"
#include "quoin/arrangement/geodesic/test_geodesics.h"
#include "quoin/base/error.h"
#include "quoin/base/test_rounds.h"

namespace quoin::test_geodesics {
namespace {

using Point = GeodesicFamily::Point;
using Pieces = PieceList<GeodesicFamily>;

struct Arc {
  Triple source;
  Triple target;
  Triple normal;
};

/// An arc of any length with exact ends on its plane, now and then a circle or one with antipodal ends.
Arc draw_arc(Directions& directions) {
  while (true) {
    Arc arc;
    arc.source = directions.next();
    const Triple other = directions.next();
    arc.normal = cross_product(arc.source, other);
    if (is_zero(arc.normal)) continue;
    if (directions.below(2) == 0) arc.normal = opposite(arc.normal);
    const std::uint64_t kind = directions.below(6);
    arc.target = kind == 0 ? arc.source : kind == 1 ? opposite(arc.source) : other;
    return arc;
  }
}

/// Directions on the plane of an arc, those that matter among them.
std::vector<Triple> directions_on_plane(const Arc& arc) {
  std::vector<Triple> result{arc.source, arc.target, cross_product(arc.normal, arc.source),
                             cross_product(arc.normal, arc.target)};
  for (const Triple& other : {Triple{0, 0, 1}, Triple{0, 1, 0}, Triple{1, 0, 0}, Triple{1, 1, 1}, Triple{1, -1, 2}}) {
    const Triple d = cross_product(arc.normal, other);
    if (!is_zero(d)) result.push_back(d);
  }
  if (arc.normal[2].sign() == Sign::zero) result.push_back({0, 0, 1});
  const std::size_t count = result.size();
  for (std::size_t i = 0; i < count; ++i) result.push_back(opposite(result[i]));
  for (std::size_t i = 0; i < count; ++i) {
    Triple sum;
    for (std::size_t k = 0; k < 3; ++k) sum[k] = result[i][k] + Rational(3) * result[(i + 1) % count][k];
    if (!is_zero(sum)) result.push_back(sum);
  }
  return result;
}

/// The piece holds the surface point.
bool piece_holds(const GeodesicFamily& family, const Pieces& list, const Piece& piece, const Triple& d) {
  const Curve c = curve_of(family, piece.branch);
  const auto place_of = [&](const Point& p) {
    const Triple ray = to_rationals(family.direction(p));
    return Place{is_pole(ray) ? c.half : ray, family.side(p)};
  };
  std::vector<Place> copies;
  if (is_pole(d)) {
    if (!c.is_vertical) return false;
    copies.push_back({c.half, d[2].sign() == Sign::negative ? Side::bottom : Side::top});
  } else if (is_identified(d)) {
    copies = {{d, Side::left}, {d, Side::right}};
  } else {
    copies.push_back({d, Side::interior});
  }
  return std::any_of(copies.begin(), copies.end(), [&](const Place& p) {
    return is_on_curve(p, c) && compare_places(place_of(list.points[piece.left]), p) != Sign::positive &&
           compare_places(p, place_of(list.points[piece.right])) != Sign::positive;
  });
}

void check_pieces(const GeodesicFamily& family, const Pieces& list, std::size_t first_piece, const Arc& arc) {
  for (std::size_t i = first_piece; i < list.pieces.size(); ++i) {
    const Piece& piece = list.pieces[i];
    const Point& left = list.points[piece.left];
    const Point& right = list.points[piece.right];
    ASSERT_EQ(family.compare_xy(left, right), Sign::negative);
    if (!family.is_vertical(piece.branch)) {
      ASSERT_TRUE(family.side(left) == Side::interior || family.side(left) == Side::left);
      ASSERT_TRUE(family.side(right) == Side::interior || family.side(right) == Side::right);
    } else {
      ASSERT_NE(family.side(left), Side::right);
      ASSERT_NE(family.side(right), Side::right);
    }
    const Triple along = to_rationals(family.normal(piece.branch));
    ASSERT_TRUE(is_zero(cross_product(along, arc.normal)));
    ASSERT_EQ(piece.reversed, scalar_product(along, arc.normal).sign() == Sign::negative);
  }
}

TEST(GeodesicPieces, PiecesCoverTheArcAndNothingElse) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < test_rounds(150U); ++seed) {
      SCOPED_TRACE(named(draw, seed));
      Directions directions(draw, seed);
      const Arc arc = draw_arc(directions);
      GeodesicFamily family;
      Pieces list;
      family.add_arc(list, arc.source, arc.target, arc.normal);
      check_pieces(family, list, 0, arc);
      if (::testing::Test::HasFatalFailure()) return;
      for (const Triple& d : directions_on_plane(arc)) {
        const bool is_held = std::any_of(list.pieces.begin(), list.pieces.end(),
                                         [&](const Piece& piece) { return piece_holds(family, list, piece, d); });
        ASSERT_EQ(is_held, is_on_arc(arc.source, arc.target, arc.normal, d))
            << text(arc.source) << text(arc.target) << text(arc.normal) << text(d);
      }
    }
  }
}

/// The 24 rotations of the cube: signed permutations of determinant 1.
std::vector<std::array<Triple, 3>> cube_rotations() {
  std::vector<std::array<Triple, 3>> rotations;
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      std::array<Triple, 3> rows;
      for (std::size_t i = 0; i < 3; ++i) {
        rows[i][static_cast<std::size_t>(order[i])] = ((signs >> i) & 1) != 0 ? -1 : 1;
      }
      if (scalar_product(rows[0], cross_product(rows[1], rows[2])).sign() == Sign::positive) {
        rotations.push_back(rows);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

Triple rotated(const std::array<Triple, 3>& rows, const Triple& d) {
  return {scalar_product(rows[0], d), scalar_product(rows[1], d), scalar_product(rows[2], d)};
}

/// Distinct points off the identification and the poles where pieces of different arcs meet, as the family tells.
std::size_t count_meetings(const std::vector<Arc>& arcs) {
  GeodesicFamily family;
  Pieces list;
  for (const Arc& arc : arcs) family.add_arc(list, arc.source, arc.target, arc.normal);
  std::vector<std::array<Integer, 3>> found;
  for (const Piece& a : list.pieces) {
    for (const Piece& b : list.pieces) {
      if (!(a.curve < b.curve) || family.same_plane(a.branch, b.branch)) continue;
      std::vector<Meeting<Point>> meetings;
      family.meetings(a.branch, b.branch, meetings);
      for (Meeting<Point>& m : meetings) {
        const auto holds = [&](const Piece& piece) {
          return family.compare_xy(list.points[piece.left], m.point) != Sign::positive &&
                 family.compare_xy(m.point, list.points[piece.right]) != Sign::positive;
        };
        if (m.point.side == Side::interior && holds(a) && holds(b)) found.push_back(family.direction(m.point));
      }
    }
  }
  std::sort(found.begin(), found.end());
  return static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
}

/// The same by definition.
std::size_t count_meetings_slowly(const std::vector<Arc>& arcs) {
  std::vector<Triple> found;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Triple d = cross_product(arcs[i].normal, arcs[j].normal);
      if (is_zero(d) || is_pole(d)) continue;
      for (const Triple& p : {d, opposite(d)}) {
        const auto holds = [&](const Arc& arc) { return is_on_arc(arc.source, arc.target, arc.normal, p); };
        if (is_identified(p) || !holds(arcs[i]) || !holds(arcs[j])) continue;
        if (std::none_of(found.begin(), found.end(), [&](const Triple& q) { return same_ray(p, q); })) {
          found.push_back(p);
        }
      }
    }
  }
  return found.size();
}

TEST(GeodesicPieces, RotationsOfTheCubeKeepWhatMeets) {
  const std::vector<std::array<Triple, 3>> rotations = cube_rotations();
  ASSERT_EQ(rotations.size(), 24U);
  for (std::uint64_t seed = 0; seed < test_rounds(5U); ++seed) {
    for (const Draw draw : {Draw::tiny, Draw::nearly_tiny, Draw::short_integers}) {
      SCOPED_TRACE(named(draw, seed));
      Directions directions(draw, seed);
      std::vector<Arc> arcs;
      for (int i = 0; i < 6; ++i) arcs.push_back(draw_arc(directions));
      for (const std::array<Triple, 3>& rows : rotations) {
        std::vector<Arc> turned;
        for (const Arc& arc : arcs) {
          turned.push_back({rotated(rows, arc.source), rotated(rows, arc.target), rotated(rows, arc.normal)});
        }
        ASSERT_EQ(count_meetings(turned), count_meetings_slowly(turned));
      }
    }
  }
}

TEST(GeodesicPieces, EqualCirclesAreOneSupport) {
  GeodesicFamily family;
  Pieces list;
  family.add_great_circle(list, Vector3{0.5, 0.25, -1});
  family.add_great_circle(list, std::array<Integer, 3>{-2, -1, 4});
  family.add_great_circle(list, std::array<Rational, 3>{Rational(1) / 3, Rational(1) / 6, Rational(-2) / 3});
  ASSERT_EQ(list.pieces.size(), 3U);
  EXPECT_TRUE(family.same_branch(list.pieces[0].branch, list.pieces[1].branch));
  EXPECT_TRUE(family.same_branch(list.pieces[0].branch, list.pieces[2].branch));
  EXPECT_TRUE(list.pieces[0].reversed);
  EXPECT_FALSE(list.pieces[1].reversed);
}

TEST(GeodesicPieces, PlanesAreOneSupportExactlyWhenTheirNormalsAreParallel) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE(named(draw, seed));
      Directions directions(draw, seed);
      GeodesicFamily family;
      Pieces list;
      std::vector<Triple> normals;
      for (int i = 0; i < 20; ++i) {
        Triple n = directions.next();
        if (i % 2 != 0) {
          // A multiple of an earlier one, now and then moved by little.
          n = normals[directions.below(normals.size())];
          const Rational factor = Rational(static_cast<int>(directions.below(1000)) + 1) / Rational(7) *
                                  Rational(directions.below(2) == 0 ? 1 : -1);
          for (Rational& value : n) value *= factor;
          if (directions.below(3) == 0) n[directions.below(3)] += Rational(std::ldexp(1.0, -60));
        }
        if (is_zero(n)) n[0] = 1;
        normals.push_back(n);
        family.add_great_circle(list, n);
      }
      std::vector<BranchId> first_branch(normals.size());
      for (const Piece& piece : list.pieces) first_branch[piece.curve.index()] = piece.branch;
      for (std::size_t i = 0; i < normals.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          ASSERT_EQ(family.same_plane(first_branch[i], first_branch[j]), is_zero(cross_product(normals[i], normals[j])))
              << text(normals[i]) << text(normals[j]);
        }
      }
    }
  }
}

TEST(GeodesicPieces, WhatIsNoArcIsRefusedByNumber) {
  GeodesicFamily family;
  Pieces list;
  family.add_point(list, Vector3{1, 0, 0});
  const auto refusal = [&](const auto& add) -> std::string {
    try {
      add();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  const std::string equal_ends = refusal([&] { family.add_arc(list, x, Vector3{3, 0, 0}); });
  EXPECT_NE(equal_ends.find("curve 1"), std::string::npos);
  EXPECT_NE(equal_ends.find("plane"), std::string::npos);
  EXPECT_NE(refusal([&] { family.add_arc(list, x, Vector3{-1, 0, 0}); }), "");
  EXPECT_NE(refusal([&] { family.add_arc(list, x, Vector3{0, 0, 0}); }), "");
  EXPECT_NE(refusal([&] { family.add_arc(list, x, y, Vector3{0, 1e-300, 1}); }), "");
  EXPECT_NE(refusal([&] { family.add_arc(list, x, y, Vector3{0, 0, 0}); }), "");
  EXPECT_NE(refusal([&] { family.add_great_circle(list, Vector3{nan, 0, 1}); }), "");
  EXPECT_NE(refusal([&] { family.add_great_circle(list, std::array<Integer, 3>{0, 0, 0}); }), "");
  EXPECT_NE(refusal([&] { family.add_point(list, Vector3{infinity, 0, 1}); }), "");
  EXPECT_NE(refusal([&] { family.make_point(Vector3{0, 0, 0}); }), "");
  EXPECT_EQ(list.curve_count, 1U);
  EXPECT_TRUE(list.pieces.empty());
  EXPECT_EQ(list.points.size(), 1U);
}

TEST(GeodesicPieces, FlattenedPiecesFollowTheirCircle) {
  for (const Draw draw : {Draw::tiny, Draw::short_integers, Draw::doubles}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      SCOPED_TRACE(named(draw, seed));
      Directions directions(draw, seed);
      const Arc arc = draw_arc(directions);
      GeodesicFamily family;
      Pieces list;
      family.add_arc(list, arc.source, arc.target, arc.normal);
      for (const Piece& piece : list.pieces) {
        const Point& left = list.points[piece.left];
        const Point& right = list.points[piece.right];
        const std::vector<Vector3> line = family.flatten(piece.branch, left, right, 0.1);
        ASSERT_EQ(line.front(), family.position(left));
        ASSERT_EQ(line.back(), family.position(right));
        for (std::size_t i = 1; i < line.size(); ++i) {
          ASSERT_LT(std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y, line[i].z - line[i - 1].z),
                    0.1001);
        }
        // Halfway lies a point that the piece holds: strictly between the ends by longitude, or by latitude.
        const Vector3 middle = line[line.size() / 2];
        if (line.size() > 2) {
          const Point p = family.make_point(middle);
          if (family.is_vertical(piece.branch)) {
            ASSERT_GE(middle.z, line.front().z);
            ASSERT_LE(middle.z, line.back().z);
          } else {
            ASSERT_EQ(family.compare_xy(left, p), Sign::negative);
            ASSERT_EQ(family.compare_xy(p, right), Sign::negative);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace quoin::test_geodesics
