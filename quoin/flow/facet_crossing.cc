// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/facet_crossing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "quoin/flow/facet_formulas.h"

namespace quoin {

namespace {

using flow::FacetLine;
using flow::LineFromMidpoint;
using flow::Vector;

constexpr std::uint32_t none = FlowPoints::none;

std::optional<Sign> sign(const Interval& value) {
  return value.sign();
}
std::optional<Sign> sign(const Rational& value) {
  return value.sign();
}

/// The polygons that are met first, one or two of them; none at infinity.
struct First {
  std::uint32_t polygon = none;
  std::uint32_t apex = none;
  std::uint32_t tied = none;
};

/// A walk along a ray of a facet: which polygons can be met, and which one is.
class Crossing {
 public:
  Crossing(FlowPoints& points, std::uint32_t point, std::uint32_t edge, Sign direction)
      : points_(points), flow_(points.complex()), faces_(flow_.faces()), point_(point), edge_(edge), way_(direction) {
    const DeloneFace from = points.face(point);
    if (from.dimension == 2) polygon_ = from.index;
    if (from.dimension == 3) polygon_ = faces_.polygons_at_edge(from.index, edge)[0];
  }

  FacetExit run() {
    if (way_ == Sign::negative && !has_any(Sign::negative)) return at_midpoint();
    if (polygon_ != none && points_.numbers() == FlowNumbers::filtered) {
      const Interval t = points_.place(point_, polygon_);
      if (std::isfinite(t.lower()) && std::isfinite(t.upper())) {
        const LineFromMidpoint<Interval> line(flow_, edge_, polygon_, apex_of(polygon_));
        const std::optional<First> first = first_met<Interval>(line.at(t));
        if (first) return first->polygon == none ? FacetExit{} : exit(*first, land(*first, line, t));
      }
    }
    const std::optional<First> first = first_met<Rational>(exact_start());
    if (!first || first->polygon == none) return {};
    const FacetExit at = exit(*first, Interval::unbounded());
    if (at.kind == FacetExit::Kind::edge) points_.exact_place(at.point, first->polygon);
    return at;
  }

 private:
  std::uint32_t apex_of(std::uint32_t polygon) const { return faces_.apex(polygon, faces_.side_of(polygon, edge_)); }
  Sign power(const RingPolygon& g) const { return flow_.signs().at_side(faces_, g.polygon, g.side); }
  bool has_any(Sign sign) const {
    const std::span<const RingPolygon> ring = faces_.ring(edge_);
    return std::any_of(ring.begin(), ring.end(), [&](const RingPolygon& g) { return power(g) == sign; });
  }

  Vector<Rational> exact_start() {
    if (polygon_ != none) {
      return LineFromMidpoint<Rational>(flow_, edge_, polygon_, apex_of(polygon_))
          .at(points_.exact_place(point_, polygon_));
    }
    const RationalPoint3 y = points_.exact(point_) - flow_.centre({1, edge_});
    return {y.x, y.y, y.z};
  }

  // Forwards, lines behind the point have y . direction <= 0, and those behind the midpoint a negative power, since
  // the point itself is between them and the midpoint is not beyond. Backwards, only lines between midpoint and point
  // count: their power and y . direction are negative. Nothing if the numbers cannot decide.
  template <class N>
  std::optional<First> first_met(const Vector<N>& y) const {
    First first;
    N best_power;
    N best_slope;
    for (const RingPolygon& g : faces_.ring(edge_)) {
      if (power(g) != way_) continue;
      const FacetLine<N> line(flow_, edge_, g.apex);
      const N slope = dot(y, line.direction);
      std::optional<Sign> later = Sign::negative;
      if (first.polygon != none) {
        // Both powers and slopes have the sign of the way: comparing quotients, signs cancel.
        later = sign(line.power * best_slope - best_power * slope);
        if (later && way_ == Sign::negative) later = -*later;
        if (later == Sign::positive) continue;
      }
      if (way_ == Sign::positive) {
        const std::optional<Sign> ahead = sign(slope);
        if (!ahead) return std::nullopt;
        if (*ahead != Sign::positive) continue;
      }
      if (!later) return std::nullopt;
      if (*later == Sign::zero) {
        first.tied = g.polygon;
        continue;
      }
      first = {g.polygon, g.apex, none};
      best_power = line.power;
      best_slope = slope;
    }
    // Without a pole the landing is monotone.
    if (first.polygon != none && sign(best_slope) != way_) return std::nullopt;
    return first;
  }

  // At the ends of the interval, since the place is a monotone function of t.
  Interval land(const First& first, const LineFromMidpoint<Interval>& from, const Interval& t) const {
    const FacetLine<Interval> line(flow_, edge_, first.apex);
    const Vector<Interval> normal = flow::normal<Interval>(flow_, first.polygon);
    const Interval low = flow::landing(line, normal, from.at(t.lower()));
    if (t.is_point()) return low;
    const Interval high = flow::landing(line, normal, from.at(t.upper()));
    return {std::min(low.lower(), high.lower()), std::max(low.upper(), high.upper())};
  }

  FacetExit exit(const First& first, const Interval& t) {
    if (first.tied != none) {
      return {FacetExit::Kind::vertex, points_.add_centre({3, faces_.common_cell(first.polygon, first.tied)})};
    }
    return {FacetExit::Kind::edge, points_.add_crossing(point_, edge_, first.polygon, t)};
  }

  FacetExit at_midpoint() {
    First touching;
    for (const RingPolygon& g : faces_.ring(edge_)) {
      if (power(g) == Sign::zero) touching = {g.polygon, g.apex, touching.polygon};
    }
    if (touching.polygon == none) return {FacetExit::Kind::midpoint, points_.add_centre({1, edge_}), true};
    if (touching.tied == none) return {FacetExit::Kind::edge, points_.add_centre({2, touching.polygon}), true};
    FacetExit at = exit(touching, {});
    at.is_at_midpoint = true;
    return at;
  }

  FlowPoints& points_;
  const FlowComplex& flow_;
  const DeloneFaces& faces_;
  std::uint32_t point_;
  std::uint32_t edge_;
  Sign way_;                      ///< positive: forward
  std::uint32_t polygon_ = none;  ///< whose Voronoi edge has the point in its closure; none for points in the facet
};

}  // namespace

FacetExit cross_forward(FlowPoints& points, std::uint32_t point, std::uint32_t edge) {
  return Crossing(points, point, edge, Sign::positive).run();
}

FacetExit cross_backward(FlowPoints& points, std::uint32_t point, std::uint32_t edge) {
  return Crossing(points, point, edge, Sign::negative).run();
}

}  // namespace quoin
