// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "quoin/arrangement/curve_family.h"
#include "quoin/arrangement/pieces.h"

/// The laws of CurveFamily, checked on any family and any list of its pieces through nothing but the concept (and
/// copies of the family). Quadratic to cubic in the number of pieces: meant for many small lists.
namespace quoin::testing {

/// Degeneracies that a list contained, so that tests can demand that their inputs have them.
struct FamilyCases {
  std::size_t vertical = 0;      ///< pieces
  std::size_t overlapping = 0;   ///< pairs of pieces on one branch that share more than a point
  std::size_t common_end = 0;    ///< pairs of pieces with an end in common
  std::size_t touching = 0;      ///< meetings without a crossing
  std::size_t crossing = 0;      ///< meetings inside both pieces with one
  std::size_t multiple = 0;      ///< points on at least three different branches
  std::size_t reversed = 0;      ///< pieces
  std::size_t repeated = 0;      ///< pairs of points that are equal
  std::size_t met_by_sweep = 0;  ///< points found by first_meeting
};

template <CurveFamily F>
class FamilyLaws {
 public:
  using Point = typename F::Point;

  FamilyLaws(const F& family, const PieceList<F>& list) : family_(family), list_(list) {}

  /// All laws but those of reversed input.
  void check() {
    check_order();
    check_pieces();
    check_pairs();
    check_around_points();
    check_absorb();
  }

  /// A family with other supports takes over this one: answers must not come from what was there before.
  void check_absorb_into(const F& other) {
    F joined = other;
    const typename F::Shift shift = joined.absorb(family_);
    std::vector<Point> moved;
    for (const Point& p : list_.points) moved.push_back(F::shifted(p, shift));
    for (std::size_t i = 0; i < moved.size(); ++i) {
      for (std::size_t j = 0; j < moved.size(); ++j) {
        ASSERT_EQ(joined.compare_xy(moved[i], moved[j]), family_.compare_xy(list_.points[i], list_.points[j]));
      }
    }
    for (const Piece& a : list_.pieces) {
      const BranchId branch = F::shifted(a.branch, shift);
      for (std::size_t i = 0; i < moved.size(); ++i) {
        const Point& p = list_.points[i];
        if (!is_interior(p) || before(p, left(a)) || before(right(a), p)) continue;
        const Sign expected = family_.compare_y_at_x(p, a.branch);
        ASSERT_EQ(joined.compare_y_at_x(moved[i], branch), expected) << "after absorb";
      }
      for (const Piece& b : list_.pieces) {
        if (family_.same_branch(a.branch, b.branch)) continue;
        std::vector<Meeting<Point>> expected;
        std::vector<Meeting<Point>> found;
        family_.meetings(a.branch, b.branch, expected);
        joined.meetings(branch, F::shifted(b.branch, shift), found);
        ASSERT_EQ(found.size(), expected.size()) << "after absorb";
        for (std::size_t k = 0; k < found.size(); ++k) {
          const Point p = F::shifted(expected[k].point, shift);
          ASSERT_EQ(joined.compare_xy(found[k].point, p), Sign::zero) << "after absorb";
          ASSERT_EQ(found[k].crosses, expected[k].crosses);
          if (!is_interior(p) || !is_inside(expected[k].point, a) || !is_inside(expected[k].point, b)) continue;
          ASSERT_EQ(joined.compare_right(branch, F::shifted(b.branch, shift), p),
                    family_.compare_right(a.branch, b.branch, expected[k].point));
        }
      }
    }
  }

  const FamilyCases& cases() const { return cases_; }

 private:
  const Point& left(const Piece& piece) const { return list_.points[piece.left]; }
  const Point& right(const Piece& piece) const { return list_.points[piece.right]; }
  bool before(const Point& p, const Point& q) const { return family_.compare_xy(p, q) == Sign::negative; }
  bool equal(const Point& p, const Point& q) const { return family_.compare_xy(p, q) == Sign::zero; }
  bool is_interior(const Point& p) const { return family_.side(p) == Side::interior; }
  /// p lies on the piece and not at its right end.
  bool leaves_right(const Point& p, const Piece& piece) const {
    return !before(p, left(piece)) && before(p, right(piece)) &&
           (equal(p, left(piece)) || family_.compare_y_at_x(p, piece.branch) == Sign::zero);
  }
  bool leaves_left(const Point& p, const Piece& piece) const {
    return before(left(piece), p) && !before(right(piece), p) &&
           (equal(p, right(piece)) || family_.compare_y_at_x(p, piece.branch) == Sign::zero);
  }
  bool is_inside(const Point& p, const Piece& piece) const { return before(left(piece), p) && before(p, right(piece)); }

  /// compare_xy is a total order that the keys agree with.
  void check_order() {
    std::vector<Point> sorted = list_.points;
    std::sort(sorted.begin(), sorted.end(), [&](const Point& p, const Point& q) { return before(p, q); });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      ASSERT_EQ(family_.compare_xy(sorted[i], sorted[i]), Sign::zero);
      Sign reached = Sign::zero;
      for (std::size_t j = i + 1; j < sorted.size(); ++j) {
        const Sign sign = family_.compare_xy(sorted[j], sorted[i]);
        ASSERT_EQ(family_.compare_xy(sorted[i], sorted[j]), -sign) << "antisymmetry of compare_xy";
        ASSERT_GE(sign, reached) << "transitivity of compare_xy";
        reached = sign;
        cases_.repeated += sign == Sign::zero ? 1 : 0;
        const double difference = family_.sweep_key(sorted[i]) - family_.sweep_key(sorted[j]);
        ASSERT_FALSE(difference > 2 * family_.key_error()) << "keys against compare_xy";
      }
    }
  }

  void check_pieces() {
    for (const Piece& piece : list_.pieces) {
      ASSERT_TRUE(before(left(piece), right(piece))) << "ends in order";
      for (const Point& end : {left(piece), right(piece)}) {
        if (is_interior(end)) {
          ASSERT_EQ(family_.compare_y_at_x(end, piece.branch), Sign::zero) << "ends on the branch";
        }
      }
      ASSERT_TRUE(family_.same_branch(piece.branch, piece.branch));
      cases_.vertical += family_.is_vertical(piece.branch) ? 1 : 0;
      cases_.reversed += piece.reversed ? 1 : 0;
    }
  }

  void check_pairs() {
    for (std::size_t i = 0; i < list_.pieces.size(); ++i) {
      for (std::size_t j = i + 1; j < list_.pieces.size(); ++j) {
        SCOPED_TRACE("pieces " + std::to_string(i) + " and " + std::to_string(j));
        check_pair(list_.pieces[i], list_.pieces[j]);
        if (::testing::Test::HasFatalFailure()) return;
      }
    }
  }

  void check_pair(const Piece& a, const Piece& b) {
    const bool same = family_.same_branch(a.branch, b.branch);
    ASSERT_EQ(family_.same_branch(b.branch, a.branch), same);
    if (same) {
      ASSERT_EQ(family_.is_vertical(a.branch), family_.is_vertical(b.branch));
    }
    cases_.common_end +=
        equal(left(a), left(b)) || equal(right(a), right(b)) || equal(left(a), right(b)) || equal(right(a), left(b))
            ? 1
            : 0;
    if (same) {
      cases_.overlapping += before(left(a), right(b)) && before(left(b), right(a)) ? 1 : 0;
      return;
    }
    std::vector<Meeting<Point>> common;
    family_.meetings(a.branch, b.branch, common);
    check_meetings(a, b, common);
    if (::testing::Test::HasFatalFailure()) return;
    const Point& start = before(left(a), left(b)) ? left(b) : left(a);
    check_first_meeting(a, b, start, common);
    for (const Meeting<Point>& meeting : common) {
      if (::testing::Test::HasFatalFailure()) return;
      if (is_inside(meeting.point, a) && is_inside(meeting.point, b)) check_first_meeting(a, b, meeting.point, common);
    }
  }

  /// Sorted, symmetric, on both branches, with the right parity.
  void check_meetings(const Piece& a, const Piece& b, const std::vector<Meeting<Point>>& common) {
    std::vector<Meeting<Point>> swapped;
    family_.meetings(b.branch, a.branch, swapped);
    ASSERT_EQ(common.size(), swapped.size()) << "symmetry of meetings";
    for (std::size_t k = 0; k < common.size(); ++k) {
      const Point& p = common[k].point;
      ASSERT_TRUE(equal(p, swapped[k].point)) << "symmetry of meetings";
      ASSERT_EQ(common[k].crosses, swapped[k].crosses) << "symmetry of crosses";
      ASSERT_TRUE(common[k].crosses || !F::meets_transversally) << "a family of curves that always cross";
      if (k > 0) {
        ASSERT_TRUE(before(common[k - 1].point, p)) << "meetings in order";
      }
      if (!is_interior(p)) continue;
      ASSERT_EQ(family_.compare_y_at_x(p, a.branch), Sign::zero) << "meetings on the first branch";
      ASSERT_EQ(family_.compare_y_at_x(p, b.branch), Sign::zero) << "meetings on the second branch";
      cases_.touching += common[k].crosses ? 0 : 1;
      if (!is_inside(p, a) || !is_inside(p, b)) continue;
      const Sign to_right = family_.compare_right(a.branch, b.branch, p);
      const Sign to_left = family_.compare_left(a.branch, b.branch, p);
      ASSERT_NE(to_right, Sign::zero);
      ASSERT_NE(to_left, Sign::zero);
      ASSERT_EQ(common[k].crosses, to_right != to_left) << "parity of a meeting";
      cases_.crossing += common[k].crosses ? 1 : 0;
    }
  }

  /// Order just right of `after`, which lies on one of the pieces and in the range of both; zero if undefined.
  Sign order_after(const Piece& a, const Piece& b, const Point& after) const {
    if (!is_interior(after) || !before(after, right(a)) || !before(after, right(b))) return Sign::zero;
    const bool on_a = leaves_right(after, a);
    const bool on_b = leaves_right(after, b);
    if (on_a && on_b) return family_.compare_right(a.branch, b.branch, after);
    if (on_a) return family_.compare_y_at_x(after, b.branch);
    return -family_.compare_y_at_x(after, a.branch);
  }

  void check_first_meeting(const Piece& a, const Piece& b, const Point& after,
                           const std::vector<Meeting<Point>>& common) {
    const Sign order = order_after(a, b, after);
    if (order == Sign::zero) return;
    const Piece& lower = order == Sign::negative ? a : b;
    const Piece& upper = order == Sign::negative ? b : a;
    Point found = after;
    const bool any = family_.first_meeting(lower.branch, right(lower), upper.branch, right(upper), after, found);
    for (const Meeting<Point>& meeting : common) {
      if (!before(after, meeting.point)) continue;
      if (before(meeting.point, right(a)) && before(meeting.point, right(b))) {
        ASSERT_TRUE(any) << "first_meeting misses a point";
        ASSERT_TRUE(equal(found, meeting.point)) << "first_meeting finds another point";
        ++cases_.met_by_sweep;
      } else if (any) {
        ASSERT_TRUE(equal(found, meeting.point)) << "first_meeting finds a point beyond the pieces";
        ASSERT_FALSE(before(right(a), found) || before(right(b), found))
            << "first_meeting finds a point beyond the end";
      }
      return;
    }
    ASSERT_FALSE(any) << "first_meeting finds a point that meetings does not";
  }

  /// Orders of all branches at a point, and that they vanish only on overlaps.
  void check_around_points() {
    for (const Point& p : list_.points) {
      if (::testing::Test::HasFatalFailure()) return;
      if (!is_interior(p)) continue;
      std::vector<BranchId> to_right;
      std::vector<BranchId> to_left;
      for (const Piece& piece : list_.pieces) {
        if (leaves_right(p, piece)) to_right.push_back(piece.branch);
        if (leaves_left(p, piece)) to_left.push_back(piece.branch);
      }
      const auto right_order = [&](BranchId a, BranchId b) { return family_.compare_right(a, b, p); };
      const auto left_order = [&](BranchId a, BranchId b) { return family_.compare_left(a, b, p); };
      check_order_around(to_right, right_order, Sign::positive);
      check_order_around(to_left, left_order, Sign::negative);
    }
  }

  template <class Order>
  void check_order_around(std::vector<BranchId>& branches, const Order& order, Sign side_of_verticals) {
    std::sort(branches.begin(), branches.end(), [&](BranchId a, BranchId b) { return order(a, b) == Sign::negative; });
    std::size_t different = branches.empty() ? 0 : 1;
    for (std::size_t i = 0; i < branches.size(); ++i) {
      ASSERT_EQ(order(branches[i], branches[i]), Sign::zero);
      Sign reached = Sign::zero;
      for (std::size_t j = i + 1; j < branches.size(); ++j) {
        const Sign sign = order(branches[j], branches[i]);
        ASSERT_EQ(order(branches[i], branches[j]), -sign) << "antisymmetry at a point";
        ASSERT_GE(sign, reached) << "transitivity at a point";
        ASSERT_EQ(sign == Sign::zero, family_.same_branch(branches[i], branches[j]))
            << "zero if and only if overlapping";
        reached = sign;
        if (family_.is_vertical(branches[j]) && !family_.is_vertical(branches[i])) {
          ASSERT_EQ(sign, side_of_verticals) << "verticals above all to the right, below all to the left";
        }
      }
      if (i > 0 && order(branches[i], branches[i - 1]) != Sign::zero) ++different;
    }
    cases_.multiple += different >= 3 ? 1 : 0;
  }

  /// What moves to another family gives the same answers, among itself and against what was there.
  void check_absorb() {
    F twice = family_;
    const typename F::Shift shift = twice.absorb(family_);
    const std::size_t count = std::min<std::size_t>(list_.points.size(), 24);
    for (std::size_t i = 0; i < count; ++i) {
      const Point p = F::shifted(list_.points[i], shift);
      ASSERT_EQ(twice.side(p), family_.side(list_.points[i]));
      for (std::size_t j = 0; j < count; ++j) {
        const Sign expected = family_.compare_xy(list_.points[i], list_.points[j]);
        ASSERT_EQ(twice.compare_xy(p, F::shifted(list_.points[j], shift)), expected);
        ASSERT_EQ(twice.compare_xy(p, list_.points[j]), expected);
      }
    }
    for (const Piece& a : list_.pieces) {
      const BranchId moved = F::shifted(a.branch, shift);
      ASSERT_TRUE(twice.same_branch(a.branch, moved));
      ASSERT_EQ(twice.is_vertical(moved), family_.is_vertical(a.branch));
      for (const Point& p : list_.points) {
        if (!is_interior(p) || before(p, left(a)) || before(right(a), p)) continue;
        const Sign expected = family_.compare_y_at_x(p, a.branch);
        ASSERT_EQ(twice.compare_y_at_x(F::shifted(p, shift), moved), expected);
        ASSERT_EQ(twice.compare_y_at_x(p, moved), expected);
      }
      for (const Piece& b : list_.pieces) {
        if (&a == &b || family_.same_branch(a.branch, b.branch)) continue;
        std::vector<Meeting<Point>> expected;
        std::vector<Meeting<Point>> found;
        family_.meetings(a.branch, b.branch, expected);
        twice.meetings(a.branch, F::shifted(b.branch, shift), found);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t k = 0; k < found.size(); ++k) {
          ASSERT_EQ(twice.compare_xy(found[k].point, expected[k].point), Sign::zero);
          ASSERT_EQ(found[k].crosses, expected[k].crosses);
        }
      }
    }
  }

  const F& family_;
  const PieceList<F>& list_;
  FamilyCases cases_;
};

/// Adds what was seen to `cases`, if given; `other` is any family with other curves, which absorbs this one.
template <CurveFamily F>
void check_family_laws(const F& family, const PieceList<F>& list, FamilyCases* cases = nullptr,
                       const F* other = nullptr) {
  FamilyLaws<F> laws(family, list);
  laws.check();
  if (other != nullptr) laws.check_absorb_into(*other);
  if (cases == nullptr) return;
  const FamilyCases& seen = laws.cases();
  cases->vertical += seen.vertical;
  cases->overlapping += seen.overlapping;
  cases->common_end += seen.common_end;
  cases->touching += seen.touching;
  cases->crossing += seen.crossing;
  cases->multiple += seen.multiple;
  cases->reversed += seen.reversed;
  cases->repeated += seen.repeated;
  cases->met_by_sweep += seen.met_by_sweep;
}

/// Two lists of one family, the second of the same curves run backwards: the same pieces with the other flag.
template <CurveFamily F>
void check_reversed(const F& family, const PieceList<F>& list, const PieceList<F>& backwards) {
  ASSERT_EQ(list.pieces.size(), backwards.pieces.size());
  std::vector<bool> used(backwards.pieces.size(), false);
  for (const Piece& piece : list.pieces) {
    bool found = false;
    for (std::size_t i = 0; i < backwards.pieces.size() && !found; ++i) {
      const Piece& other = backwards.pieces[i];
      if (used[i] || piece.curve != other.curve || piece.reversed == other.reversed) continue;
      found = family.same_branch(piece.branch, other.branch) &&
              family.compare_xy(list.points[piece.left], backwards.points[other.left]) == Sign::zero &&
              family.compare_xy(list.points[piece.right], backwards.points[other.right]) == Sign::zero;
      if (found) used[i] = true;
    }
    ASSERT_TRUE(found) << "a piece without its reverse";
  }
}

}  // namespace quoin::testing
