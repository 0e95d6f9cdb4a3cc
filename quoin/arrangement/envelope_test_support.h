// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "quoin/arrangement/circular/circular_envelope.h"
#include "quoin/arrangement/circular/circular_oracle.h"
#include "quoin/arrangement/linear/linear_envelope.h"

/// Envelopes by definition: at every x where something could change, and between, all pieces are compared by numbers
/// of another kind than those of the families. Cubic in the number of pieces.
namespace quoin::testing {

/// Rational coordinates of points and branches.
class LinearEnvelopeOracle {
 public:
  using Number = Rational;
  explicit LinearEnvelopeOracle(const LinearFamily& family) : family_(family) {}

  Rational x(const LinearPoint& p) const {
    return p.is_end() ? family_.first_support_point(BranchId(p.first)).x : family_.exact(p).x;
  }
  Rational y(const LinearPoint& p) const { return family_.exact(p).y; }
  Rational y_at(BranchId branch, const Rational& x) const {
    const RationalPoint2 a = family_.first_support_point(branch);
    const RationalPoint2 b = family_.second_support_point(branch);
    return a.y + (x - a.x) * (b.y - a.y) / (b.x - a.x);
  }

 private:
  const LinearFamily& family_;
};

class CircularEnvelopeOracle {
 public:
  using Number = LongReal;
  explicit CircularEnvelopeOracle(const CircularFamily& family) : oracle_(family) {}

  LongReal x(const CircularPoint& p) const { return oracle_.point(p).x; }
  LongReal y(const CircularPoint& p) const { return oracle_.point(p).y; }
  LongReal y_at(BranchId branch, const LongReal& x) const { return oracle_.y_at(branch, x); }

 private:
  CircularOracle oracle_;
};

/// How often what is special occurred, so that tests can demand it.
struct EnvelopeCases {
  std::size_t gaps = 0;           ///< between two breakpoints
  std::size_t overlaps = 0;       ///< intervals with several members
  std::size_t touches = 0;        ///< breakpoints between intervals of the same members
  std::size_t common_points = 0;  ///< breakpoints with three members or more
  std::size_t jumps = 0;          ///< breakpoints with no member of a neighbour
  std::size_t at_infinity = 0;    ///< breakpoints down a vertical line
};

template <class F, class Oracle>
class EnvelopeChecker {
 public:
  using Number = typename Oracle::Number;
  using Point = typename F::Point;
  using Members = std::vector<std::uint32_t>;

  EnvelopeChecker(const F& family, const PieceList<F>& list) : family_(family), list_(list), oracle_(family) {
    find_samples();
  }

  void check(EnvelopeCases& cases) {
    for (const bool upper : {false, true}) {
      SCOPED_TRACE(upper ? "upper" : "lower");
      const Context context;
      const Envelope<F> found =
          upper ? upper_envelope(family_, list_, context) : lower_envelope(family_, list_, context);
      compare(found, upper);
      if (::testing::Test::HasFatalFailure()) return;
      count(found, cases);
    }
  }

 private:
  /// A height over some x; `level` is -1 or 1 at infinity.
  struct Height {
    int level = 0;
    Number y{};
  };

  static bool less(const Number& a, const Number& b) { return (a - b).sign() == Sign::negative; }
  static bool equal(const Number& a, const Number& b) { return (a - b).sign() == Sign::zero; }
  Height height(const Point& p) const {
    const Side side = family_.side(p);
    if (side != Side::interior) return {side == Side::bottom ? -1 : 1, {}};
    return {0, oracle_.y(p)};
  }
  static Sign compare(const Height& a, const Height& b) {
    if (a.level != b.level) return a.level < b.level ? Sign::negative : Sign::positive;
    return a.level != 0 ? Sign::zero : (a.y - b.y).sign();
  }

  /// Every x that may be a breakpoint is samples_[1], [3], ...; the others lie between them and beyond.
  void find_samples() {
    std::vector<Number> events;
    for (const Point& p : list_.points) {
      if (family_.side(p) != Side::left && family_.side(p) != Side::right) events.push_back(oracle_.x(p));
    }
    std::vector<Meeting<Point>> meetings;
    for (const Piece& a : list_.pieces) {
      for (const Piece& b : list_.pieces) {
        if (!family_.same_branch(a.branch, b.branch)) family_.meetings(a.branch, b.branch, meetings);
      }
    }
    for (const Meeting<Point>& meeting : meetings) events.push_back(oracle_.x(meeting.point));
    std::sort(events.begin(), events.end(), less);
    events.erase(std::unique(events.begin(), events.end(), equal), events.end());
    const Number one(Rational(1));
    const Number half(Rational(0.5));
    for (std::size_t i = 0; i < events.size(); ++i) {
      samples_.push_back(i == 0 ? events[0] - one : (events[i - 1] + events[i]) * half);
      samples_.push_back(events[i]);
    }
    samples_.push_back(events.empty() ? Number(Rational(0)) : events.back() + one);
  }

  /// The lowest members at a sample.
  Members lowest(const Number& x, bool upper, Height& best) const {
    Members members;
    const auto offer = [&](const Height& at, std::size_t member) {
      const Sign sign = members.empty() ? Sign::negative : upper ? compare(best, at) : compare(at, best);
      if (sign == Sign::positive) return;
      if (sign == Sign::negative) members.clear();
      members.push_back(static_cast<std::uint32_t>(member));
      best = at;
    };
    for (std::size_t i = 0; i < list_.pieces.size(); ++i) {
      const Piece& piece = list_.pieces[i];
      const Point& left = list_.points[piece.left];
      const Point& right = list_.points[piece.right];
      if (family_.side(left) != Side::left && less(x, oracle_.x(left))) continue;
      if (family_.side(right) != Side::right && less(oracle_.x(right), x)) continue;
      offer(family_.is_vertical(piece.branch) ? height(upper ? right : left) : Height{0, oracle_.y_at(piece.branch, x)},
            i);
    }
    for (std::size_t i = 0; i < list_.lone_points.size(); ++i) {
      const Point& p = list_.points[list_.lone_points[i].point];
      if (equal(oracle_.x(p), x)) offer(height(p), list_.pieces.size() + i);
    }
    return members;
  }

  void compare(const Envelope<F>& found, bool upper) const {
    ASSERT_EQ(found.interval_count(), found.breakpoint_count() + 1);
    std::size_t interval = 0;
    Height best;
    Members before = lowest(samples_[0], upper, best);
    std::size_t arcs = before.empty() ? 0 : 1;
    ASSERT_EQ(vector_of(found.over(0)), before) << "at the left";
    for (std::size_t i = 1; i + 1 < samples_.size(); i += 2) {
      Height above;
      const Members at = lowest(samples_[i], upper, best);
      const Members after = lowest(samples_[i + 1], upper, above);
      if (at == before && at == after) continue;
      ASSERT_LT(interval, found.breakpoint_count());
      ASSERT_TRUE(equal(oracle_.x(found.point(interval)), samples_[i])) << "breakpoint " << interval;
      ASSERT_EQ(compare(height(found.point(interval)), best), Sign::zero) << "breakpoint " << interval;
      ASSERT_EQ(vector_of(found.at(interval)), at) << "breakpoint " << interval;
      ++interval;
      ASSERT_EQ(vector_of(found.over(interval)), after) << "interval " << interval;
      ASSERT_EQ(found.is_gap(interval), after.empty());
      if (!after.empty()) {
        ASSERT_EQ(found.branch(interval), list_.pieces[after[0]].branch);
        ++arcs;
      }
      before = after;
    }
    ASSERT_EQ(found.breakpoint_count(), interval);
    ASSERT_EQ(found.arc_count(), arcs);
  }

  static Members vector_of(std::span<const std::uint32_t> members) { return {members.begin(), members.end()}; }

  void count(const Envelope<F>& envelope, EnvelopeCases& cases) const {
    for (std::size_t i = 0; i < envelope.interval_count(); ++i) {
      if (envelope.is_gap(i) && i > 0 && i < envelope.breakpoint_count()) ++cases.gaps;
      if (envelope.over(i).size() > 1) ++cases.overlaps;
    }
    for (std::size_t i = 0; i < envelope.breakpoint_count(); ++i) {
      const Members at = vector_of(envelope.at(i));
      const Members left = vector_of(envelope.over(i));
      const Members right = vector_of(envelope.over(i + 1));
      if (left == right && !left.empty()) ++cases.touches;
      if (at.size() > 2) ++cases.common_points;
      if (family_.side(envelope.point(i)) != Side::interior) ++cases.at_infinity;
      const auto is_in = [&](std::uint32_t m) {
        return std::ranges::count(left, m) > 0 || std::ranges::count(right, m) > 0;
      };
      if (!std::ranges::any_of(at, is_in)) ++cases.jumps;
    }
  }

  const F& family_;
  const PieceList<F>& list_;
  Oracle oracle_;
  std::vector<Number> samples_;
};

using LinearEnvelopeChecker = EnvelopeChecker<LinearFamily, LinearEnvelopeOracle>;
using CircularEnvelopeChecker = EnvelopeChecker<CircularFamily, CircularEnvelopeOracle>;

}  // namespace quoin::testing
