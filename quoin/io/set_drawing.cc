// SPDX-License-Identifier: Apache-2.0
#include "quoin/io/set_drawing.h"

#include <algorithm>
#include <cmath>

#include "quoin/base/error.h"
#include "quoin/io/piece_bulge.h"

namespace quoin {

namespace {

constexpr unsigned most_rounds = 16;

/// Vertices of an arrangement in doubles.
struct RoundedVertices {
  std::vector<Point2> points;
  double max_displacement = 0;
};

/// An upper bound of the distance between a rational point and its rounding.
double distance_bound(const RationalPoint2& exact, const Point2& rounded) {
  const Rational dx = abs(exact.x - Rational(rounded.x));
  const Rational dy = abs(exact.y - Rational(rounded.y));
  return std::nextafter(std::hypot(dx.to_double(), dy.to_double()) * (1 + 0x1p-50), HUGE_VAL);
}

RoundedVertices round_vertices(const LinearArrangement& arrangement) {
  RoundedVertices result;
  for (std::size_t v = 0; v < arrangement.vertex_count(); ++v) {
    if (!arrangement.cells().is_real(dcel::VertexId(v))) break;  // what lies at infinity comes last
    const LinearPoint& point = arrangement.point(dcel::VertexId(v));
    if (point.is_explicit()) {
      result.points.push_back({point.x, point.y});
      continue;
    }
    const RationalPoint2 exact = arrangement.family().exact(point);
    const Point2 rounded{exact.x.to_double(), exact.y.to_double()};
    if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y)) throw InputError("a vertex lies beyond all doubles");
    result.points.push_back(rounded);
    if (Rational(rounded.x) != exact.x || Rational(rounded.y) != exact.y) {
      result.max_displacement = std::max(result.max_displacement, distance_bound(exact, rounded));
    }
  }
  return result;
}

void drop_repeated(std::vector<Point2>& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
}

DrawingElement polygon_element(DrawingPolygon polygon, std::size_t number) {
  DrawingElement element;
  element.shape = std::move(polygon);
  element.name = "polygon " + std::to_string(number);
  return element;
}

/// Rounds and draws one state of the set; says whether its rounded rings still bound polygons of the same number.
class LinearRound {
 public:
  LinearRound(const LinearPolygonSet& set, const Context& context) : set_(set), context_(context) {}

  /// Adds to the report.
  void draw(SetDrawing& report) {
    const RoundedVertices rounded = round_vertices(set_.arrangement());
    displaced_ = rounded.max_displacement > 0;
    report.max_displacement += rounded.max_displacement;
    report.drawing.elements.clear();
    for (const PolygonWithHoles& polygon : polygons_of(set_)) {
      DrawingPolygon drawn;
      add_ring(polygon.outer, rounded, drawn, report);
      if (drawn.rings.empty()) {
        report.vanished_rings += polygon.holes.size();
        continue;
      }
      for (const PolygonRing& hole : polygon.holes) add_ring(hole, rounded, drawn, report);
      report.drawing.elements.push_back(polygon_element(std::move(drawn), report.drawing.elements.size() + 1));
    }
  }

  bool is_exact() const { return !displaced_; }

  /// The rounded rings arranged: valid if they meet in their vertices only and wind once around what they enclose.
  bool is_valid(LinearPolygonSet& mended) {
    const LinearArrangement drawn = arrange(family_, list_, context_);
    const std::uint32_t rings = list_.curve_count;
    const RegionGroups groups{std::vector<std::uint32_t>(rings, 0), {FillRule::positive}, {0}, 1};
    mended = combine_regions(drawn, groups, SetOperation::unite);
    return drawn.edge_count() == list_.pieces.size() && mended.arrangement().counts().edges == drawn.edge_count() &&
           mended.arrangement().counts().faces == drawn.counts().faces;
  }

 private:
  void add_ring(const PolygonRing& ring, const RoundedVertices& rounded, DrawingPolygon& drawn, SetDrawing& report) {
    DrawingPath path;
    path.is_closed = true;
    for (const dcel::HalfedgeId h : ring.halfedges) {
      path.points.push_back(rounded.points[set_.arrangement().cells().origin(h).index()]);
    }
    drop_repeated(path.points);
    if (path.points.size() < 3) {
      ++report.vanished_rings;
      return;
    }
    family_.add_polyline(list_, path.points, true);
    drawn.rings.push_back(std::move(path));
  }

  const LinearPolygonSet& set_;
  const Context& context_;
  LinearFamily family_;
  PieceList<LinearFamily> list_;
  bool displaced_ = false;
};

}  // namespace

SetDrawing draw_set(const LinearPolygonSet& set, const Context& context) {
  SetDrawing report;
  LinearPolygonSet current = set;
  for (;; ++report.rounds) {
    LinearRound round(current, context);
    round.draw(report);
    LinearPolygonSet mended;
    if (round.is_exact() || round.is_valid(mended)) return report;
    if (report.rounds == most_rounds) throw InputError("the set does not settle on doubles: rounding keeps moving it");
    current = std::move(mended);
  }
}

SetDrawing draw_set(const CircularPolygonSet& set, const Context&) {
  SetDrawing report;
  const CircularArrangement& arrangement = set.arrangement();
  const auto position = [&](dcel::VertexId v) { return arrangement.family().position(arrangement.point(v)); };
  report.max_displacement = arrangement.family().error();
  const auto add_ring = [&](const PolygonRing& ring, DrawingPolygon& drawn) {
    DrawingPath path;
    path.is_closed = true;
    bool is_curved = false;
    for (const dcel::HalfedgeId h : ring.halfedges) {
      const Point2 from = position(arrangement.cells().origin(h));
      const Point2 to = position(arrangement.cells().target(h));
      if (from == to) continue;  // too short for doubles
      path.points.push_back(from);
      const double bulge = bulge_between(arrangement.family(), arrangement.branch(h.edge()), from, to);
      path.bulges.push_back(h.is_forward() ? bulge : -bulge);
      is_curved = is_curved || path.bulges.back() != 0;
    }
    if (!is_curved) path.bulges.clear();
    if (path.points.size() < (is_curved ? 2 : 3)) {
      ++report.vanished_rings;
    } else {
      drawn.rings.push_back(std::move(path));
    }
  };
  for (const PolygonWithHoles& polygon : polygons_of(set)) {
    DrawingPolygon drawn;
    add_ring(polygon.outer, drawn);
    if (drawn.rings.empty()) {
      report.vanished_rings += polygon.holes.size();
      continue;
    }
    for (const PolygonRing& hole : polygon.holes) add_ring(hole, drawn);
    report.drawing.elements.push_back(polygon_element(std::move(drawn), report.drawing.elements.size() + 1));
  }
  return report;
}

}  // namespace quoin
