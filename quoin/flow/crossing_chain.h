// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "quoin/flow/histogram.h"
#include "quoin/flow/rounded_ray.h"
#include "quoin/kernel/rational_point.h"
#include "quoin/number/rational.h"

namespace quoin {

/// Vertices of a triangle in an order that gives its normal.
using FlowTriangle = std::array<std::uint32_t, 3>;

/// Points that the flow constructs one from another, by input points alone: each is a place on the Voronoi edge of a
/// triangle, a double with a bound of its error when somebody needs one, and a rational where that cannot decide.
class CrossingChain {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  /// The points must outlive it.
  explicit CrossingChain(std::span<const Point3> points);

  void clear();
  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }

  /// The circumcentre of a triangle.
  std::uint32_t add_centre(const FlowTriangle& triangle);
  /// The circumcentre of a simplex.
  std::uint32_t add_centre(const FlowTriangle& triangle, std::uint32_t apex);
  /// Where the ray from the midpoint of (p0, p1) through a point on the Voronoi edge of (p0, p1, apex) meets that of
  /// (p0, p1, q).
  std::uint32_t add_landing(std::uint32_t from, const FlowTriangle& entry, std::uint32_t q);
  /// The same, where the place is known.
  std::uint32_t add_landing(std::uint32_t from, const FlowTriangle& entry, std::uint32_t q,
                            const flow::RoundedPlace& place);

  /// The ray from the midpoint of the first two corners through a point; they and the third are the triangle whose
  /// Voronoi edge has the point. May be no usable one.
  flow::RoundedRay ray(std::uint32_t node, const FlowTriangle& entry);
  /// On which side of its triangle's plane a point is: positive where the normal points.
  Sign side(std::uint32_t node);
  /// Sign of the difference of the places of two points on one Voronoi edge: positive where the first is further along
  /// the normal of its own triangle.
  Sign compare(std::uint32_t node, std::uint32_t other);
  /// The place of a point on the Voronoi edge of a triangle that is, or has the same circle as, the point's.
  Rational exact_place(std::uint32_t node, const FlowTriangle& triangle);
  RationalPoint3 exact_point(std::uint32_t node);
  /// Within a part of the largest coordinate, its own or of its triangle; 2^-30 are nine digits, 2^-20 six. Much
  /// quicker than exact ones where doubles tell as much, which after long chains they may not.
  Point3 near_point(std::uint32_t node, double part = 0x1p-30);
  const FlowTriangle& triangle(std::uint32_t node) const { return nodes_[node].triangle; }

  /// The longest row of landings, each constructed from the one before, of all points so far; `clear` keeps it.
  std::size_t most_depth() const { return most_depth_; }
  std::size_t exact_count() const { return exact_count_; }
  /// Bits of the largest numerator or denominator among places that were computed exactly.
  std::size_t most_bits() const { return most_bits_; }
  /// Bytes of numerator and denominator together, of each place that was computed exactly.
  const Histogram& exact_bytes() const { return exact_bytes_; }
  const std::array<const Point3*, 3> corners(const FlowTriangle& t) const {
    return {&points_[t[0]], &points_[t[1]], &points_[t[2]]};
  }

 private:
  enum class State : std::uint8_t { unknown, rounded, vague };
  struct Node {
    FlowTriangle triangle;
    std::uint32_t parent = none;
    std::uint32_t apex = none;  ///< of the entry triangle; without a parent, of the simplex
    std::uint32_t depth = 0;    ///< landings up to it
    State state = State::unknown;
    flow::RoundedPlace place{};
  };
  void round(std::uint32_t node);
  void round_one(Node& node);
  bool convert(const Node& node, const FlowTriangle& entry, flow::RoundedPlace& place) const;
  const Rational& exact(std::uint32_t node);
  Rational landing(const Node& node);
  std::uint32_t add(Node node);

  std::span<const Point3> points_;
  double scale_ = 1;
  std::vector<Node> nodes_;
  std::unordered_map<std::uint32_t, Rational> exact_;
  std::size_t exact_count_ = 0;
  std::size_t most_bits_ = 0;
  std::size_t most_depth_ = 0;
  Histogram exact_bytes_;
};

}  // namespace quoin
