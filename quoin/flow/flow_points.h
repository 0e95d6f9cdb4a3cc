// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "quoin/flow/flow_complex.h"
#include "quoin/number/interval.h"
#include "quoin/number/rational.h"

namespace quoin {

/// How questions about constructed points are answered; the answers are the same.
enum class FlowNumbers {
  filtered,  ///< by intervals, and by rationals where those cannot decide
  exact      ///< by rationals alone
};

/// Points that the flow constructs one from another, exact, evaluated as far as somebody asks.
///
/// A point on a Voronoi edge is one number t on the edge's line: an interval that is kept, and a rational that is
/// computed when a question needs it, for the point and those it came from. Where an orbit reaches a Voronoi vertex the
/// point is known from the input alone, so the chain of constructions ends. Source: section 5.2 of Cazals,
/// Parameswaran and Pion; departs from it: one number per point instead of three coordinates and a graph of operations.
class FlowPoints {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// The complex must outlive it.
  explicit FlowPoints(const FlowComplex& flow, FlowNumbers numbers = FlowNumbers::filtered)
      : flow_(&flow), numbers_(numbers) {}

  const FlowComplex& complex() const { return *flow_; }
  FlowNumbers numbers() const { return numbers_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }

  /// The centre of a face that is on its dual: an input point, a midpoint, a circumcentre.
  std::uint32_t add_centre(DeloneFace face);
  /// Any point of the dual of a face.
  std::uint32_t add_place(const RationalPoint3& place, DeloneFace face);
  /// Where the line from the midpoint of the edge through a point meets the Voronoi edge of a polygon.
  std::uint32_t add_crossing(std::uint32_t parent, std::uint32_t edge, std::uint32_t polygon, const Interval& t);

  /// The face whose dual has the point.
  DeloneFace face(std::uint32_t point) const { return points_[point].face; }
  RationalPoint3 exact(std::uint32_t point);
  /// Each coordinate the nearest double.
  Point3 rounded(std::uint32_t point);
  /// Sign of t of a point on a Voronoi edge: on which side of the polygon's plane it is.
  Sign side(std::uint32_t point);

  /// The place t of a point on the line of a polygon that its face has or is.
  Interval place(std::uint32_t point, std::uint32_t polygon) const;
  Rational exact_place(std::uint32_t point, std::uint32_t polygon);

  /// How many consecutive constructions lead to the point.
  std::size_t depth(std::uint32_t point) const;
  /// How many points were evaluated exactly.
  std::size_t exact_count() const { return exact_count_; }
  void clear() { points_.clear(); }

 private:
  struct Node {
    DeloneFace face;
    std::uint32_t parent = none;
    std::uint32_t edge = none;
    bool is_centre = false;
    Interval t;
    std::optional<Rational> exact_t{};
    std::optional<RationalPoint3> place{};
  };
  std::uint32_t add(Node node);
  std::uint32_t apex_of_cell(std::uint32_t cell, std::uint32_t polygon) const;
  Rational landing(const Node& node);
  const Rational& exact_t(std::uint32_t point);

  const FlowComplex* flow_;
  FlowNumbers numbers_;
  std::vector<Node> points_;
  std::size_t exact_count_ = 0;
};

}  // namespace quoin
