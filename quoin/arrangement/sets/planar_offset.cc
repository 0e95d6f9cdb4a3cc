// SPDX-License-Identifier: Apache-2.0
#include "quoin/arrangement/sets/planar_offset.h"

#include <algorithm>
#include <cmath>

#include "quoin/arrangement/sets/planar_normals.h"
#include "quoin/arrangement/sets/planar_rings.h"
#include "quoin/base/error.h"

namespace quoin {

namespace {

using planar::Direction;
using planar::PlanarPoint;
using planar::PlanarRing;
using planar::UnitBracket;

/// A ring in the order in which the set to grow lies on its left, with the outer normals of its edges.
struct Outline {
  std::vector<PlanarPoint> points;
  std::vector<UnitBracket> normals;
  std::vector<bool> is_convex;  // by point

  std::size_t next(std::size_t i) const { return i + 1 == points.size() ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? points.size() - 1 : i - 1; }
};

Outline outline_of(PlanarRing ring, bool is_inset, const Rational& cosine) {
  Outline result;
  result.points = std::move(ring.points);
  if (is_inset) std::reverse(result.points.begin(), result.points.end());
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const PlanarPoint& before = result.points[result.previous(i)];
    const PlanarPoint& after = result.points[result.next(i)];
    const RationalPoint2 a = result.points[i].exact();
    const RationalPoint2 b = after.exact();
    result.normals.push_back(planar::unit_bracket({b.y - a.y, a.x - b.x}, cosine));
    result.is_convex.push_back(Direction::turn({before, result.points[i]}, {result.points[i], after}) ==
                               Sign::positive);
  }
  return result;
}

/// Draws offset chains; those of insets backwards, since they take away.
class ChainWriter {
 public:
  ChainWriter(const Rational& radius, bool is_inset)
      : radius_(planar::planar_point({radius, Rational(0)})), exact_radius_(radius), is_inset_(is_inset) {}

  void add(const Outline& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const PlanarPoint& start = ring.points[i];
      const UnitBracket& before = ring.normals[ring.previous(i)];
      const UnitBracket& normal = ring.normals[i];
      const PlanarPoint arrival = away(start, before.counterclockwise);
      const PlanarPoint departure = away(start, normal.clockwise);
      if (ring.is_convex[i] && turns_left(before.counterclockwise, normal.clockwise)) {
        add_arc(start, arrival, departure);
      } else if (before.counterclockwise != normal.clockwise) {
        add_segment(arrival, start);
        add_segment(start, departure);
      }
      add_segment(departure, away(ring.points[ring.next(i)], normal.counterclockwise));
    }
  }
  CircularPolygonSet finish(const Context& context) {
    const std::vector<std::uint32_t> operands(list_.curve_count, 0);
    return combine_rings(std::move(family_), list_, operands, 1, FillRule::positive, SetOperation::unite, context);
  }

 private:
  static bool turns_left(const RationalPoint2& a, const RationalPoint2& b) {
    return (a.x * b.y - a.y * b.x).sign() == Sign::positive;
  }
  PlanarPoint away(const PlanarPoint& from, const RationalPoint2& unit) const {
    const RationalPoint2 p = from.exact();
    return planar::planar_point({p.x + exact_radius_ * unit.x, p.y + exact_radius_ * unit.y});
  }
  void add_segment(const PlanarPoint& start, const PlanarPoint& end) {
    const PlanarPoint& from = is_inset_ ? end : start;
    const PlanarPoint& to = is_inset_ ? start : end;
    if (from.is_double() && to.is_double()) {
      family_.add_segment(list_, from.rounded, to.rounded, "an edge of the offset");
    } else {
      family_.add_segment(list_, from.exact(), to.exact(), "an edge of the offset");
    }
  }
  void add_arc(const PlanarPoint& centre, const PlanarPoint& start, const PlanarPoint& end) {
    const PlanarPoint& from = is_inset_ ? end : start;
    const PlanarPoint& to = is_inset_ ? start : end;
    const auto direction =
        is_inset_ ? CircularFamily::Direction::clockwise : CircularFamily::Direction::counterclockwise;
    if (centre.is_double() && radius_.is_double() && from.is_double() && to.is_double()) {
      family_.add_arc(list_, centre.rounded, radius_.rounded.x, from.rounded, to.rounded, direction,
                      "an arc of the offset");
    } else {
      const RationalPoint2 c = centre.exact();
      family_.add_arc(list_, RationalCircle{c.x, c.y, exact_radius_ * exact_radius_}, from.exact(), to.exact(),
                      direction, "an arc of the offset");
    }
  }

  PlanarPoint radius_;  // as x
  Rational exact_radius_;
  bool is_inset_;
  CircularFamily family_;
  PieceList<CircularFamily> list_;
};

CircularPolygonSet drawn(const std::vector<Outline>& outlines, const Rational& radius, bool is_inset,
                         const Context& context) {
  ChainWriter writer(radius, is_inset);
  for (const Outline& outline : outlines) {
    context.poll();
    writer.add(outline);
  }
  return writer.finish(context);
}

/// With cosines of at least radius / (radius + bound) the rectangles of the given radius are within the trapezoids of
/// the larger one, and those of radius^2 / (radius + bound) > radius - bound within the trapezoids of the given one.
PlanarOffset moved_boundary(const LinearPolygonSet& set, const Rational& radius, const PlanarOffsetOptions& options,
                            bool is_inset, const Context& context) {
  if (radius.sign() != Sign::positive) throw InputError("the radius of an offset must be positive");
  if (options.bound.sign() == Sign::negative) throw InputError("the bound of an offset must not be negative");
  PlanarOffset result;
  result.bound = options.bound.sign() == Sign::zero ? radius * Rational(0x1p-20) : options.bound;
  const Rational larger = radius + result.bound;
  std::vector<Outline> outlines;
  result.is_exact = true;
  for (planar::PlanarComponent& component : planar::components_of(set, "the set to offset")) {
    for (PlanarRing& ring : component.rings) {
      context.poll();
      outlines.push_back(outline_of(std::move(ring), is_inset, radius / larger));
      for (const UnitBracket& normal : outlines.back().normals) result.is_exact &= normal.is_exact;
    }
  }
  result.inner = drawn(outlines, radius, is_inset, context);
  result.outer = result.is_exact ? result.inner : drawn(outlines, larger, is_inset, context);
  if (is_inset) std::swap(result.inner, result.outer);
  if (result.is_exact) result.bound = Rational(0);
  return result;
}

Rational finite(double radius) {
  if (!std::isfinite(radius)) throw InputError("the radius of an offset must be finite");
  return radius;
}

}  // namespace

PlanarOffset offset(const LinearPolygonSet& set, const Rational& radius, const PlanarOffsetOptions& options,
                    const Context& context) {
  return moved_boundary(set, radius, options, false, context);
}

PlanarOffset offset(const LinearPolygonSet& set, double radius, const PlanarOffsetOptions& options,
                    const Context& context) {
  return offset(set, finite(radius), options, context);
}

PlanarOffset inset(const LinearPolygonSet& set, const Rational& radius, const PlanarOffsetOptions& options,
                   const Context& context) {
  return moved_boundary(set, radius, options, true, context);
}

PlanarOffset inset(const LinearPolygonSet& set, double radius, const PlanarOffsetOptions& options,
                   const Context& context) {
  return inset(set, finite(radius), options, context);
}

}  // namespace quoin
