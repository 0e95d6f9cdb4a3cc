// SPDX-License-Identifier: Apache-2.0
#include "quoin/flow/flow_orbit.h"

#include <algorithm>
#include <utility>

#include "quoin/flow/facet_crossing.h"
#include "quoin/flow/nearest_face.h"

namespace quoin {

namespace {

constexpr std::uint32_t none = FlowPoints::none;

/// One step, with what it is about.
class Step {
 public:
  Step(FlowPoints& points, std::uint32_t point, AtRegularPoint at_regular)
      : points_(points), flow_(points.complex()), faces_(flow_.faces()), point_(point), at_regular_(at_regular) {
    step_.segment.start = points.face(point);
  }

  FlowStep run() {
    switch (step_.segment.start.dimension) {
      case 0:
        return leave_cell();
      case 1:
        return leave_facet();
      case 2:
        return leave_edge();
      default:
        return leave_vertex();
    }
  }

 private:
  FlowStep stop() {
    step_.stops = true;
    return step_;
  }

  FlowStep reach(DeloneFace crossed, std::uint32_t point) {
    step_.segment.crossed = crossed;
    step_.point = point;
    if (point != none) step_.segment.reached = points_.face(point);
    return step_;
  }

  FlowStep through_facet(std::uint32_t edge) { return reach({1, edge}, cross_forward(points_, point_, edge).point); }

  /// Along a Voronoi edge to one of its ends.
  FlowStep along(std::uint32_t polygon, std::size_t side) {
    const std::uint32_t cell = faces_.cells_of_polygon(polygon)[side];
    return reach({2, polygon}, cell == DeloneFaces::outside ? none : points_.add_centre({3, cell}));
  }

  std::size_t side_away_from(std::uint32_t polygon, std::uint32_t cell) const {
    return faces_.cells_of_polygon(polygon)[0] == cell ? 1 : 0;
  }

  FlowStep leave_vertex() {
    const std::uint32_t cell = step_.segment.start.index;
    const DeloneFace crossed = flow_.crossed({3, cell});
    if (crossed.dimension == 2) return along(crossed.index, side_away_from(crossed.index, cell));
    if (crossed.dimension == 1) return through_facet(crossed.index);
    if (at_regular_ == AtRegularPoint::stop || flow_.is_critical({3, cell})) return stop();
    for (const std::uint32_t f : faces_.polygons_of_cell(cell)) {
      const std::size_t away = side_away_from(f, cell);
      if (flow_.signs().at_polygon(f, 1 - away) != Sign::zero) continue;
      step_.passes = true;
      return along(f, away);
    }
    return stop();
  }

  FlowStep leave_edge() {
    const std::uint32_t polygon = step_.segment.start.index;
    const DeloneFace crossed = flow_.crossed({2, polygon});
    if (crossed.dimension == 1) return through_facet(crossed.index);
    const Sign side = points_.side(point_);
    if (side != Sign::zero) return along(polygon, side == Sign::positive ? 1 : 0);
    if (at_regular_ == AtRegularPoint::stop || flow_.is_critical({2, polygon})) return stop();
    step_.passes = true;
    return along(polygon, 0);
  }

  FlowStep leave_facet() {
    const std::uint32_t edge = step_.segment.start.index;
    if (points_.exact(point_) == flow_.centre({1, edge})) return stop();
    return through_facet(edge);
  }

  // The ray from the input point through this one meets the bisector of the input point and q where it has gone
  // |q|^2 / (2 x . q) times its length.
  FlowStep leave_cell() {
    const std::uint32_t vertex = step_.segment.start.index;
    const RationalPoint3 origin = exact_point(flow_.point(vertex));
    const RationalPoint3 x = points_.exact(point_) - origin;
    if (x == RationalPoint3{}) return stop();
    Rational least;
    std::vector<std::uint32_t> first;
    for (const std::uint32_t e : faces_.edges_of_vertex(vertex)) {
      const std::array<std::uint32_t, 2> ends = faces_.edge(e);
      const RationalPoint3 q = exact_point(flow_.point(ends[0] == vertex ? ends[1] : ends[0])) - origin;
      const Rational ahead = dot(x, q);
      if (ahead.sign() != Sign::positive) continue;
      const Rational length = dot(q, q) / (ahead * Rational(2));
      if (!first.empty() && length > least) continue;
      if (first.empty() || length < least) first.clear();
      least = length;
      first.push_back(e);
    }
    if (first.empty()) return reach({0, vertex}, none);
    return reach({0, vertex}, points_.add_place(origin + x * least, face_of_edges(faces_, vertex, first)));
  }

  FlowPoints& points_;
  const FlowComplex& flow_;
  const DeloneFaces& faces_;
  std::uint32_t point_;
  AtRegularPoint at_regular_;
  FlowStep step_;
};

}  // namespace

FlowStep flow_step(FlowPoints& points, std::uint32_t point, AtRegularPoint at_regular) {
  return Step(points, point, at_regular).run();
}

FlowOrbit flow_orbit(const FlowComplex& flow, const RationalPoint3& start, const Context& context,
                     AtRegularPoint at_regular) {
  FlowOrbit orbit{.points = FlowPoints(flow), .segments = {}};
  std::uint32_t at = orbit.points.add_place(start, nearest_face(flow, start));
  while (true) {
    context.poll();
    orbit.end = orbit.points.face(at);
    const FlowStep step = flow_step(orbit.points, at, at_regular);
    if (step.stops) return orbit;
    orbit.has_passed_regular |= step.passes;
    orbit.segments.push_back(step.segment);
    at = step.point;
    orbit.is_infinite = at == none;
    if (orbit.is_infinite) return orbit;
  }
}

}  // namespace quoin
