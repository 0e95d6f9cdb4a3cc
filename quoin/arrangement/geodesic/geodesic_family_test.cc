// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/geodesic/geodesic_family.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "quoin/arrangement/geodesic/test_geodesics.h"
#include "quoin/base/test_rounds.h"

namespace quoin::test_geodesics {
namespace {

using Point = GeodesicFamily::Point;
using Pieces = PieceList<GeodesicFamily>;

struct KnownPoint {
  Point point;
  Place place;
};

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
      if (!is_zero(cross_product(s, end))) family.add_arc(list, s, end);
    }
  }

  void add_random_arc() {
    const Triple s = draw_directions.next();
    const Triple t = draw_directions.next();
    if (!is_zero(cross_product(s, t))) family.add_arc(list, s, t);
  }

  void add_point(const Triple& d) {
    family.add_point(list, d);
    Place place{d, Side::interior};
    if (is_pole(d)) {
      place = {{-1, 0, 0}, d[2].sign() == Sign::negative ? Side::bottom : Side::top};
    } else if (is_identified(d)) {
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
        const Triple d = to_rationals(family.direction(p));
        const bool at_pole = is_pole(d);
        points.push_back({p, {at_pole ? c.half : d, family.side(p)}});
      }
    }
  }

  void add_meetings() {
    for (std::size_t i = 0; i < branches.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        std::vector<Meeting<Point>> found;
        family.meetings(branches[i], branches[j], found);
        const std::vector<Place> expected = common_places(curves[i], curves[j]);
        ASSERT_EQ(found.size(), expected.size()) << text(curves[i].normal) << text(curves[j].normal);
        for (std::size_t k = 0; k < found.size(); ++k) {
          ASSERT_TRUE(found[k].crosses);
          ASSERT_EQ(family.side(found[k].point), expected[k].side);
          ASSERT_TRUE(same_ray(to_rationals(family.direction(found[k].point)), expected[k].ray))
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

/// Calls the function with worlds of every draw.
template <class Function>
void for_worlds(std::uint64_t seeds, std::size_t size, const Function& function) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < test_rounds(seeds); ++seed) {
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
        const Sign expected = compare_places(p.place, q.place);
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
        if (w.curves[i].is_vertical && !is_on_half(p.place.ray, w.curves[i])) continue;
        ASSERT_EQ(w.family.compare_y_at_x(p.point, w.branches[i]), side_of_curve(p.place, w.curves[i]))
            << text(p.place.ray) << text(w.curves[i].normal);
      }
    }
  });
}

TEST(GeodesicFamily, OrderBesideAPointIsThatOfTheHeightsThere) {
  for_worlds(12, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      for (std::size_t i = 0; i < w.branches.size(); ++i) {
        if (!is_on_curve(p.place, w.curves[i])) continue;
        for (std::size_t j = 0; j < w.branches.size(); ++j) {
          if (!is_on_curve(p.place, w.curves[j])) continue;
          ASSERT_EQ(w.family.compare_right(w.branches[i], w.branches[j], p.point),
                    compare_beside(w.curves[i], w.curves[j], p.place, 1))
              << text(p.place.ray) << text(w.curves[i].normal) << text(w.curves[j].normal);
          ASSERT_EQ(w.family.compare_left(w.branches[i], w.branches[j], p.point),
                    compare_beside(w.curves[i], w.curves[j], p.place, -1))
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
    return side_of_curve(p, a) == Sign::negative ? Sign::positive : Sign::negative;
  }
  const Sign order = compare(height(a, p.ray[0], p.ray[1]), height(b, p.ray[0], p.ray[1]));
  if (order != Sign::zero) return order;
  return compare_beside(a, b, p, side_of_curve(p, a) == Sign::negative ? -1 : 1);
}

/// Checks the first meeting of branches i and j after a point for ends drawn among the known points.
void check_first_meeting(World& w, std::size_t i, std::size_t j, const KnownPoint& after) {
  const auto draw_end = [&](std::size_t branch) -> const KnownPoint* {
    for (int tries = 0; tries < 30; ++tries) {
      const KnownPoint& p = w.points[w.draw_directions.below(w.points.size())];
      if (p.place.side == Side::left && !w.curves[branch].is_vertical) continue;
      if (!is_on_curve(p.place, w.curves[branch])) continue;
      if (compare_places(after.place, p.place) == Sign::negative) return &p;
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
  const bool i_ends_first = compare_places(end_i->place, end_j->place) == Sign::negative;
  const Place& end = i_ends_first ? end_i->place : end_j->place;
  SCOPED_TRACE(text(w.curves[i].normal) + text(w.curves[j].normal) + " after " + text(after.place.ray) + " ends " +
               text(end_i->place.ray) + text(end_j->place.ray));
  for (const Place& p : common_places(w.curves[i], w.curves[j])) {
    if (compare_places(after.place, p) != Sign::negative) continue;
    const Sign order = compare_places(p, end);
    if (order == Sign::negative) {
      ASSERT_TRUE(has_found);
      ASSERT_TRUE(same_ray(to_rationals(w.family.direction(found)), p.ray));
      ASSERT_EQ(w.family.side(found), p.side);
      return;
    }
  }
  ASSERT_FALSE(has_found);  // ends that are common points are left out
}

/// The point lies on the line of a vertical branch, or not before the left end of another one.
bool has_begun(const Curve& c, const Place& p) {
  if (c.is_vertical) return is_on_half(p.ray, c);
  return !is_identified(p.ray) || side_of_curve(p, c) != Sign::negative;
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

TEST(GeodesicFamily, PositionsAreWithinTheirError) {
  for_worlds(5, 5, [](const World& w) {
    for (const KnownPoint& p : w.points) {
      const Vector3 position = w.family.position(p.point);
      const bool is_pole_end = p.place.side == Side::bottom || p.place.side == Side::top;
      Triple d = p.place.ray;
      if (is_pole_end) d = {0, 0, p.place.side == Side::top ? 1 : -1};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double square = (d[axis] * d[axis] / scalar_product(d, d)).to_double();
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

// A plane that both families have keeps the normal of the one that absorbs, whose integers may be longer: exact
// arithmetic on the other one's points needs more words then.
TEST(GeodesicFamily, AbsorbedPointsMayNeedLongerNumbers) {
  for (unsigned scale = 1; scale < 300; scale += 13) {
    SCOPED_TRACE(scale);
    Integer factor(1);
    for (unsigned i = 0; i < scale; ++i) factor = factor * Integer(3);
    GeodesicFamily a;
    GeodesicFamily b;
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i) {
      const std::array<Integer, 3> n{Integer(3 * i - 5), Integer(7 - i * i), Integer(i + 1)};
      a.add_circle(std::array<Integer, 3>{n[0] * factor, n[1] * factor, n[2] * factor});
      b.add_circle(n);
    }
    for (std::uint32_t i = 0; i < 3; ++i) points.push_back(b.make_crossing(i, i + 1, i % 2 == 0 ? 1 : -1));
    const GeodesicFamily::Shift shift = a.absorb(b);
    ASSERT_EQ(a.support_count(), 4U);
    for (const Point& p : points) {
      const Point moved = GeodesicFamily::shifted(p, shift);
      const Point made = a.make_crossing(p.first, p.second, p.sign);
      ASSERT_EQ(a.compare_xy(moved, made), Sign::zero);
      for (int step = -1; step <= 1; ++step) {  // beside it, too close for doubles
        std::array<Integer, 3> near = b.direction(p);
        for (Integer& value : near) value <<= 46;
        near[1] = near[1] + Integer(step);
        ASSERT_EQ(a.compare_xy(moved, a.make_point(near)), b.compare_xy(p, b.make_point(near)));
      }
      for (std::uint32_t i = 0; i < 4; ++i) {
        const BranchId branch = GeodesicFamily::branch(i, false);
        ASSERT_EQ(a.compare_y_at_x(moved, branch), b.compare_y_at_x(p, branch));
      }
    }
  }
}

TEST(GeodesicFamily, AbsorbedPointsAndBranchesAreTheSame) {
  for (const Draw draw : all_draws) {
    for (std::uint64_t seed = 0; seed < test_rounds(4U); ++seed) {
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
          ASSERT_EQ(family.compare_xy(moved, q.point), compare_places(p.place, q.place));
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
      const std::array<Triple, 2> normals{cross_product(s, t), cross_product(s, near)};
      if (is_zero(normals[0]) || is_zero(normals[1]) || is_identified(s)) continue;
      GeodesicFamily family;
      Pieces list;
      for (const Triple& n : normals) family.add_great_circle(list, n);
      const BranchId a = list.pieces.front().branch;
      const BranchId b = list.pieces.back().branch;
      const Point p = family.make_point(s);
      ASSERT_EQ(family.compare_right(a, b, p),
                compare_beside(curve_of(family, a), curve_of(family, b), {s, Side::interior}, 1))
          << text(s) << text(t) << text(near);
    }
  }
}

}  // namespace
}  // namespace quoin::test_geodesics
