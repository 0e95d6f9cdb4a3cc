// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "quoin/arrangement/test_geodesics.h"
#include "quoin/base/error.h"

namespace quoin {
namespace {

using test_geodesics::all_draws;
using test_geodesics::Curve;
using test_geodesics::Directions;
using test_geodesics::Draw;
using test_geodesics::height;
using test_geodesics::is_zero;
using test_geodesics::Place;
using test_geodesics::same_ray;
using test_geodesics::text;
using test_geodesics::Triple;

using Point = GeodesicFamily::Point;
using Pieces = PieceList<GeodesicFamily>;

struct KnownPoint {
  Point point;
  Place place;
};

Curve curve_of(const GeodesicFamily& family, BranchId b) {
  Curve c;
  c.normal = test_geodesics::to_rationals(family.normal(b));
  c.is_vertical = family.is_vertical(b);
  // The half meridian that runs upward about its normal: h = e_z x n.
  if (c.is_vertical) c.half = {-c.normal[1], c.normal[0], 0};
  return c;
}

/// A family with circles, arcs and points, every point together with where it must be.
struct World {
  World(Draw draw, std::uint64_t seed, std::size_t size) : draw_directions(draw, seed) {
    for (std::size_t i = 0; i < size; ++i) {
      family.add_great_circle(list, draw_directions.next());
      add_random_arc();
      add_point(draw_directions.next());
    }
    for (std::size_t i = 0; i < 2; ++i) add_narrow_pair();
    collect_branches();
    collect_piece_ends();
    add_meetings();
  }

  /// Two arcs from one source whose planes are nearly parallel: only a common point far from rounding tells their
  /// order.
  void add_narrow_pair() {
    const Triple s = draw_directions.next();
    const Triple t = draw_directions.next();
    const Triple change = draw_directions.next();
    constexpr std::array<int, 4> exponents{44, 52, 60, 130};
    const Rational tiny(std::ldexp(1.0, -exponents[draw_directions.below(4)]));
    Triple near;
    for (std::size_t axis = 0; axis < 3; ++axis) near[axis] = t[axis] + tiny * change[axis];
    for (const Triple& end : {t, near}) {
      if (!is_zero(test_geodesics::cross_product(s, end))) family.add_arc(list, s, end);
    }
  }

  void add_random_arc() {
    const Triple s = draw_directions.next();
    const Triple t = draw_directions.next();
    if (!is_zero(test_geodesics::cross_product(s, t))) family.add_arc(list, s, t);
  }

  void add_point(const Triple& d) {
    family.add_point(list, d);
    Place place{d, Side::interior};
    if (test_geodesics::is_pole(d)) {
      place = {{-1, 0, 0}, d[2].sign() == Sign::negative ? Side::bottom : Side::top};
    } else if (test_geodesics::is_identified(d)) {
      place.side = Side::left;
    }
    points.push_back({list.points[list.lone_points.back().point], place});
  }

  void collect_branches() {
    for (const Piece& piece : list.pieces) {
      if (std::find(branches.begin(), branches.end(), piece.branch) != branches.end()) continue;
      branches.push_back(piece.branch);
      curves.push_back(curve_of(family, piece.branch));
    }
  }

  void collect_piece_ends() {
    for (const Piece& piece : list.pieces) {
      const Curve c = curve_of(family, piece.branch);
      for (const std::uint32_t end : {piece.left, piece.right}) {
        const Point& p = list.points[end];
        const Triple d = test_geodesics::to_rationals(family.direction(p));
        const bool is_pole = test_geodesics::is_pole(d);
        points.push_back({p, {is_pole ? c.half : d, family.side(p)}});
      }
    }
  }

  void add_meetings() {
    for (std::size_t i = 0; i < branches.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        std::vector<Meeting<Point>> found;
        family.meetings(branches[i], branches[j], found);
        const std::vector<Place> expected = test_geodesics::common_places(curves[i], curves[j]);
        ASSERT_EQ(found.size(), expected.size()) << text(curves[i].normal) << text(curves[j].normal);
        for (std::size_t k = 0; k < found.size(); ++k) {
          ASSERT_TRUE(found[k].crosses);
          ASSERT_EQ(family.side(found[k].point), expected[k].side);
          ASSERT_TRUE(same_ray(test_geodesics::to_rationals(family.direction(found[k].point)), expected[k].ray))
              << text(curves[i].normal) << text(curves[j].normal);
          if (draw_directions.below(4) == 0 || points.size() < 40) points.push_back({found[k].point, expected[k]});
        }
      }
    }
  }

  Directions draw_directions;
  GeodesicFamily family;
  Pieces list;
  std::vector<KnownPoint> points;
  std::vector<BranchId> branches;
  std::vector<Curve> curves;
};

std::string named(Draw draw, std::uint64_t seed) {
  return "draw " + std::to_string(static_cast<int>(draw)) + " seed " + std::to_string(seed);
}

/// Calls the function with worlds of every draw.
template <class Function>
void for_worlds(std::uint64_t seeds, std::size_t size, const Function& function) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      SCOPED_TRACE(named(draw, seed));
      World world(draw, seed, size);
      if (::testing::Test::HasFatalFailure()) return;
      function(world);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

TEST(GeodesicFamily, PointsAreOrderedByLongitudeThenLatitude) {
  for_worlds(12, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      for (const KnownPoint& q : w.points) {
        const Sign expected = test_geodesics::compare_places(p.place, q.place);
        ASSERT_EQ(w.family.compare_xy(p.point, q.point), expected) << text(p.place.ray) << text(q.place.ray);
        if (w.family.sweep_key(p.point) - w.family.sweep_key(q.point) > 2 * w.family.key_error()) {
          ASSERT_EQ(expected, Sign::positive) << text(p.place.ray) << text(q.place.ray);
        }
      }
    }
  });
}

TEST(GeodesicFamily, TheOrderIsTotal) {
  for_worlds(4, 5, [](const World& w) {
    std::vector<Point> sorted;
    for (const KnownPoint& p : w.points) sorted.push_back(p.point);
    std::sort(sorted.begin(), sorted.end(),
              [&](const Point& p, const Point& q) { return w.family.compare_xy(p, q) == Sign::negative; });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      for (std::size_t j = i; j < sorted.size(); ++j) {
        ASSERT_NE(w.family.compare_xy(sorted[i], sorted[j]), Sign::positive);
        ASSERT_EQ(w.family.compare_xy(sorted[j], sorted[i]), -w.family.compare_xy(sorted[i], sorted[j]));
      }
    }
  });
}

TEST(GeodesicFamily, SidesAreThoseOfTheHeightAboveTheLongitude) {
  for_worlds(12, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      for (std::size_t i = 0; i < w.branches.size(); ++i) {
        if (w.curves[i].is_vertical && !test_geodesics::is_on_half(p.place.ray, w.curves[i])) continue;
        ASSERT_EQ(w.family.compare_y_at_x(p.point, w.branches[i]), test_geodesics::side_of_curve(p.place, w.curves[i]))
            << text(p.place.ray) << text(w.curves[i].normal);
      }
    }
  });
}

TEST(GeodesicFamily, OrderBesideAPointIsThatOfTheHeightsThere) {
  for_worlds(12, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      for (std::size_t i = 0; i < w.branches.size(); ++i) {
        if (!test_geodesics::is_on_curve(p.place, w.curves[i])) continue;
        for (std::size_t j = 0; j < w.branches.size(); ++j) {
          if (!test_geodesics::is_on_curve(p.place, w.curves[j])) continue;
          ASSERT_EQ(w.family.compare_right(w.branches[i], w.branches[j], p.point),
                    test_geodesics::compare_beside(w.curves[i], w.curves[j], p.place, 1))
              << text(p.place.ray) << text(w.curves[i].normal) << text(w.curves[j].normal);
          ASSERT_EQ(w.family.compare_left(w.branches[i], w.branches[j], p.point),
                    test_geodesics::compare_beside(w.curves[i], w.curves[j], p.place, -1))
              << text(p.place.ray) << text(w.curves[i].normal) << text(w.curves[j].normal);
        }
      }
    }
  });
}

/// Order just after a point: of two branches where it lies on the line of the vertical one, if there is one. Two that
/// meet above it, at its longitude, have not met yet.
Sign order_right_of(const Curve& a, const Curve& b, const Place& p) {
  if (a.is_vertical) return -order_right_of(b, a, p);
  if (b.is_vertical) {
    // The vertical continues just above p.
    return test_geodesics::side_of_curve(p, a) == Sign::negative ? Sign::positive : Sign::negative;
  }
  const Sign order = test_geodesics::compare(height(a, p.ray[0], p.ray[1]), height(b, p.ray[0], p.ray[1]));
  if (order != Sign::zero) return order;
  return test_geodesics::compare_beside(a, b, p, test_geodesics::side_of_curve(p, a) == Sign::negative ? -1 : 1);
}

/// Checks the first meeting of branches i and j after a point for ends drawn among the known points.
void check_first_meeting(World& w, std::size_t i, std::size_t j, const KnownPoint& after) {
  const auto draw_end = [&](std::size_t branch) -> const KnownPoint* {
    for (int tries = 0; tries < 30; ++tries) {
      const KnownPoint& p = w.points[w.draw_directions.below(w.points.size())];
      if (p.place.side == Side::left && !w.curves[branch].is_vertical) continue;
      if (!test_geodesics::is_on_curve(p.place, w.curves[branch])) continue;
      if (test_geodesics::compare_places(after.place, p.place) == Sign::negative) return &p;
    }
    return nullptr;
  };
  const KnownPoint* end_i = draw_end(i);
  const KnownPoint* end_j = draw_end(j);
  if (end_i == nullptr || end_j == nullptr) return;
  const bool i_is_lower = order_right_of(w.curves[i], w.curves[j], after.place) == Sign::negative;
  Point found;
  const bool has_found =
      i_is_lower ? w.family.first_meeting(w.branches[i], end_i->point, w.branches[j], end_j->point, after.point, found)
                 : w.family.first_meeting(w.branches[j], end_j->point, w.branches[i], end_i->point, after.point, found);
  const bool i_ends_first = test_geodesics::compare_places(end_i->place, end_j->place) == Sign::negative;
  const Place& end = i_ends_first ? end_i->place : end_j->place;
  SCOPED_TRACE(text(w.curves[i].normal) + text(w.curves[j].normal) + " after " + text(after.place.ray) + " ends " +
               text(end_i->place.ray) + text(end_j->place.ray));
  for (const Place& p : test_geodesics::common_places(w.curves[i], w.curves[j])) {
    if (test_geodesics::compare_places(after.place, p) != Sign::negative) continue;
    const Sign order = test_geodesics::compare_places(p, end);
    if (order == Sign::negative) {
      ASSERT_TRUE(has_found);
      ASSERT_TRUE(same_ray(test_geodesics::to_rationals(w.family.direction(found)), p.ray));
      ASSERT_EQ(w.family.side(found), p.side);
      return;
    }
  }
  ASSERT_FALSE(has_found);  // ends that are common points are left out
}

/// The point lies on the line of a vertical branch, or not before the left end of another one.
bool has_begun(const Curve& c, const Place& p) {
  if (c.is_vertical) return test_geodesics::is_on_half(p.ray, c);
  return !test_geodesics::is_identified(p.ray) || test_geodesics::side_of_curve(p, c) != Sign::negative;
}

TEST(GeodesicFamily, FirstMeetingIsTheFirstCommonPointBeforeTheEnds) {
  for_worlds(8, 5, [](World& w) {
    const std::vector<KnownPoint> points = w.points;
    for (std::size_t i = 0; i < w.branches.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (int tries = 0; tries < 8; ++tries) {
          const KnownPoint& after = points[w.draw_directions.below(points.size())];
          if (after.place.side == Side::right || w.family.same_plane(w.branches[i], w.branches[j])) continue;
          const bool is_in_range = has_begun(w.curves[i], after.place) && has_begun(w.curves[j], after.place);
          if (!is_in_range) continue;
          check_first_meeting(w, i, j, after);
          if (::testing::Test::HasFatalFailure()) return;
        }
      }
    }
  });
}

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
    arc.normal = test_geodesics::cross_product(arc.source, other);
    if (is_zero(arc.normal)) continue;
    if (directions.below(2) == 0) arc.normal = test_geodesics::opposite(arc.normal);
    const std::uint64_t kind = directions.below(6);
    arc.target = kind == 0 ? arc.source : kind == 1 ? test_geodesics::opposite(arc.source) : other;
    return arc;
  }
}

/// Directions on the plane of an arc, those that matter among them.
std::vector<Triple> directions_on_plane(const Arc& arc) {
  using test_geodesics::cross_product;
  std::vector<Triple> result{arc.source, arc.target, cross_product(arc.normal, arc.source),
                             cross_product(arc.normal, arc.target)};
  for (const Triple& other : {Triple{0, 0, 1}, Triple{0, 1, 0}, Triple{1, 0, 0}, Triple{1, 1, 1}, Triple{1, -1, 2}}) {
    const Triple d = cross_product(arc.normal, other);
    if (!is_zero(d)) result.push_back(d);
  }
  if (arc.normal[2].sign() == Sign::zero) result.push_back({0, 0, 1});
  const std::size_t count = result.size();
  for (std::size_t i = 0; i < count; ++i) result.push_back(test_geodesics::opposite(result[i]));
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
    const Triple ray = test_geodesics::to_rationals(family.direction(p));
    return Place{test_geodesics::is_pole(ray) ? c.half : ray, family.side(p)};
  };
  std::vector<Place> copies;
  if (test_geodesics::is_pole(d)) {
    if (!c.is_vertical) return false;
    copies.push_back({c.half, d[2].sign() == Sign::negative ? Side::bottom : Side::top});
  } else if (test_geodesics::is_identified(d)) {
    copies = {{d, Side::left}, {d, Side::right}};
  } else {
    copies.push_back({d, Side::interior});
  }
  return std::any_of(copies.begin(), copies.end(), [&](const Place& p) {
    return test_geodesics::is_on_curve(p, c) &&
           test_geodesics::compare_places(place_of(list.points[piece.left]), p) != Sign::positive &&
           test_geodesics::compare_places(p, place_of(list.points[piece.right])) != Sign::positive;
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
    const Triple along = test_geodesics::to_rationals(family.normal(piece.branch));
    ASSERT_TRUE(is_zero(test_geodesics::cross_product(along, arc.normal)));
    ASSERT_EQ(piece.reversed, test_geodesics::scalar_product(along, arc.normal).sign() == Sign::negative);
  }
}

TEST(GeodesicFamily, PiecesCoverTheArcAndNothingElse) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
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
        ASSERT_EQ(is_held, test_geodesics::is_on_arc(arc.source, arc.target, arc.normal, d))
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
      if (test_geodesics::scalar_product(rows[0], test_geodesics::cross_product(rows[1], rows[2])).sign() ==
          Sign::positive) {
        rotations.push_back(rows);
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return rotations;
}

Triple rotated(const std::array<Triple, 3>& rows, const Triple& d) {
  return {test_geodesics::scalar_product(rows[0], d), test_geodesics::scalar_product(rows[1], d),
          test_geodesics::scalar_product(rows[2], d)};
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
      const Triple d = test_geodesics::cross_product(arcs[i].normal, arcs[j].normal);
      if (is_zero(d) || test_geodesics::is_pole(d)) continue;
      for (const Triple& p : {d, test_geodesics::opposite(d)}) {
        const auto holds = [&](const Arc& arc) {
          return test_geodesics::is_on_arc(arc.source, arc.target, arc.normal, p);
        };
        if (test_geodesics::is_identified(p) || !holds(arcs[i]) || !holds(arcs[j])) continue;
        if (std::none_of(found.begin(), found.end(), [&](const Triple& q) { return same_ray(p, q); })) {
          found.push_back(p);
        }
      }
    }
  }
  return found.size();
}

TEST(GeodesicFamily, RotationsOfTheCubeKeepWhatMeets) {
  const std::vector<std::array<Triple, 3>> rotations = cube_rotations();
  ASSERT_EQ(rotations.size(), 24U);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
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

TEST(GeodesicFamily, PositionsAreWithinTheirError) {
  for_worlds(5, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      const Vector3 position = w.family.position(p.point);
      const bool is_pole_end = p.place.side == Side::bottom || p.place.side == Side::top;
      Triple d = p.place.ray;
      if (is_pole_end) d = {0, 0, p.place.side == Side::top ? 1 : -1};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double square = (d[axis] * d[axis] / test_geodesics::scalar_product(d, d)).to_double();
        const double expected = to_int(d[axis].sign()) * std::sqrt(square);
        ASSERT_NEAR(position[axis], expected, w.family.error() + 0x1p-51) << text(d);
      }
    }
  });
}

TEST(GeodesicFamily, RightCopiesHaveLeftCopies) {
  for_worlds(5, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      const Point left = w.family.left_copy(p.point);
      if (p.place.side != Side::right) {
        ASSERT_EQ(w.family.compare_xy(left, p.point), Sign::zero);
        continue;
      }
      ASSERT_EQ(w.family.side(left), Side::left);
      ASSERT_EQ(w.family.compare_xy(left, p.point), Sign::negative);
      ASSERT_EQ(w.family.direction(left), w.family.direction(p.point));
    }
  });
}

TEST(GeodesicFamily, AbsorbedPointsAndBranchesAreTheSame) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(named(draw, seed));
      World a(draw, seed, 4);
      World b(draw, seed + 1000, 4);
      if (HasFatalFailure()) return;
      GeodesicFamily family = a.family;
      const GeodesicFamily::Shift shift = family.absorb(b.family);
      for (const KnownPoint& p : b.points) {
        const Point moved = GeodesicFamily::shifted(p.point, shift);
        ASSERT_EQ(family.direction(moved), b.family.direction(p.point));
        for (const KnownPoint& q : a.points) {
          ASSERT_EQ(family.compare_xy(moved, q.point), test_geodesics::compare_places(p.place, q.place));
        }
      }
      for (std::size_t i = 0; i < b.branches.size(); ++i) {
        const BranchId moved = GeodesicFamily::shifted(b.branches[i], shift);
        ASSERT_EQ(family.normal(moved), b.family.normal(b.branches[i]));
        for (std::size_t j = 0; j < a.branches.size(); ++j) {
          ASSERT_EQ(family.same_branch(moved, a.branches[j]), family.normal(moved) == family.normal(a.branches[j]));
        }
      }
    }
  }
}

TEST(GeodesicFamily, EqualCirclesAreOneSupport) {
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

TEST(GeodesicFamily, SlopesOfNearlyParallelPlanesAreToldApart) {
  for (const Draw draw : {Draw::short_integers, Draw::doubles, Draw::long_integers}) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      SCOPED_TRACE(named(draw, seed));
      Directions directions(draw, seed);
      const Triple s = directions.next();
      const Triple t = directions.next();
      const Triple change = directions.next();
      Triple near;
      const Rational tiny(std::ldexp(1.0, -44 - static_cast<int>(directions.below(12))));
      for (std::size_t axis = 0; axis < 3; ++axis) near[axis] = t[axis] + tiny * change[axis];
      const std::array<Triple, 2> normals{test_geodesics::cross_product(s, t), test_geodesics::cross_product(s, near)};
      if (is_zero(normals[0]) || is_zero(normals[1]) || test_geodesics::is_identified(s)) continue;
      GeodesicFamily family;
      Pieces list;
      for (const Triple& n : normals) family.add_great_circle(list, n);
      const BranchId a = list.pieces.front().branch;
      const BranchId b = list.pieces.back().branch;
      const Point p = family.make_point(s);
      ASSERT_EQ(family.compare_right(a, b, p),
                test_geodesics::compare_beside(curve_of(family, a), curve_of(family, b), {s, Side::interior}, 1))
          << text(s) << text(t) << text(near);
    }
  }
}

TEST(GeodesicFamily, PlanesAreOneSupportExactlyWhenTheirNormalsAreParallel) {
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
          ASSERT_EQ(family.same_plane(first_branch[i], first_branch[j]),
                    is_zero(test_geodesics::cross_product(normals[i], normals[j])))
              << text(normals[i]) << text(normals[j]);
        }
      }
    }
  }
}

TEST(GeodesicFamily, WhatIsNoArcIsRefusedByNumber) {
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

TEST(GeodesicFamily, FlattenedPiecesFollowTheirCircle) {
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
}  // namespace quoin
