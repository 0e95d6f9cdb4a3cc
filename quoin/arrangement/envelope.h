// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quoin/arrangement/location/location.h"
#include "quoin/arrangement/pieces.h"
#include "quoin/base/context.h"

namespace quoin {

/// The lowest (or highest) points of curves over every x, as a list over x from left to right.
///
/// k breakpoints divide the x-axis into k + 1 open intervals; the first and the last one reach to infinity. Over an
/// interval the same *members* are lowest everywhere: pieces, several where they overlap, or none (a gap). At a
/// breakpoint its own members are lowest: curves are closed, so ends belong to them, and a vertical piece or a lone
/// point is met only there. An x is a breakpoint if and only if the members just left of it, at it and just right of it
/// are not all the same; so a curve that touches the envelope from above makes a breakpoint.
///
/// Members are numbers: below the number of pieces of the list a piece, from there on a lone point. They ascend.
template <class F>
class Envelope {
 public:
  using Point = typename F::Point;
  using Members = std::span<const std::uint32_t>;

  std::size_t breakpoint_count() const { return breakpoints_.size(); }
  /// One more than breakpoints, gaps included.
  std::size_t interval_count() const { return intervals_.size(); }
  /// Intervals that are no gaps.
  std::size_t arc_count() const { return arc_count_; }

  /// The lowest point over a breakpoint; where a vertical curve goes down without bound, its end at infinity.
  const Point& point(std::size_t breakpoint) const { return breakpoints_[breakpoint].point; }
  /// What is lowest at a breakpoint; never empty.
  Members at(std::size_t breakpoint) const { return members(breakpoints_[breakpoint].members); }
  /// What is lowest over interval i, which lies between the breakpoints i - 1 and i; empty: a gap.
  Members over(std::size_t interval) const { return members(intervals_[interval].members); }
  bool is_gap(std::size_t interval) const { return intervals_[interval].members.count == 0; }
  /// That of the first member, or none.
  BranchId branch(std::size_t interval) const { return intervals_[interval].branch; }

 private:
  struct Range {
    std::uint64_t first = 0;
    std::uint32_t count = 0;
  };
  struct Breakpoint {
    Point point;
    Range members;
  };
  struct Interval {
    BranchId branch;
    Range members;
  };
  template <class>
  friend class EnvelopeBuilder;

  Members members(const Range& range) const { return {members_.data() + range.first, range.count}; }

  std::vector<Breakpoint> breakpoints_;
  std::vector<Interval> intervals_{Interval{}};
  std::vector<std::uint32_t> members_;  // equal neighbours share a range
  std::size_t arc_count_ = 0;
};

/// The curve that a member of an envelope of the list belongs to.
template <class F>
CurveId curve_of_member(const PieceList<F>& list, std::uint32_t member) {
  return member < list.pieces.size() ? list.pieces[member].curve : list.lone_points[member - list.pieces.size()].curve;
}

/// The lower envelope of pieces and lone points in the plane. Rays and lines are followed to infinity.
///
/// Exact; overlaps, equal curves, common ends, touching without crossing, vertical pieces and gaps are ordinary.
/// Divides the pieces, and merges two envelopes by one pass over x: O(lambda(n) log n) predicates, where lambda(n)
/// bounds the size of an envelope: n for lines, n alpha(n) for segments, and little more for arcs. Members are named at
/// the end only, so overlaps cost what the answer holds. Source: Agarwal and Sharir, Davenport-Schinzel Sequences and
/// Their Geometric Applications, 1995, section 6.2.
/// @throws Cancelled
template <VerticalFamily F>
Envelope<F> lower_envelope(const F& family, const PieceList<F>& list, const Context& context);

/// The highest points instead of the lowest.
template <VerticalFamily F>
Envelope<F> upper_envelope(const F& family, const PieceList<F>& list, const Context& context);

}  // namespace quoin
