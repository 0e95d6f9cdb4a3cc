// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/constrained2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/constructed_predicates2.h"
#include "quoin/triangulation/insertion_rounds2.h"
#include "quoin/triangulation/segment_insertion2.h"

namespace quoin {

namespace {

constexpr unsigned axis = 2;
constexpr std::uint32_t none = Vertex2::none_value;

PointId id(std::size_t v) {
  return PointId(v);
}

Sign turn_of(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
}

}  // namespace

ConstrainedDelaunay2::ConstrainedDelaunay2(std::span<const Point2> points, std::span<const Segment2> segments,
                                           const Context& context)
    : pieces_(cut_segments(points, segments, context)) {
  const std::size_t count = vertex_count();
  const auto turn_to = [&](std::uint32_t i) { return pieces_.table.turn_any(id(0), id(1), id(i), axis); };
  const auto start = detail::first_triangle(count, turn_to, context);
  if (!start) {
    dimension_ = count == 0 ? -1 : count == 1 ? 0 : 1;
    links_ = Triangulation2({}, count);
    return;
  }
  require_edge_codes(count);
  dimension_ = 2;
  const ConstructedPredicates2 predicates(pieces_.table);
  TriangleArray2 triangles = detail::insert_in_rounds(predicates, count, *start, InsertionSplit::none(), context);
  detail::SegmentInsertion2<ConstructedPredicates2> insertion(predicates, triangles, count, context);
  for (std::size_t i = 0; i < pieces_.pieces.size(); ++i) {
    if (i % 64 == 0) context.poll();
    insertion.insert(pieces_.pieces[i].source.value, pieces_.pieces[i].target.value);
  }
  links_ = Triangulation2(std::move(triangles), count);
  mark_pieces();
}

// Pieces by their source, and those by their target: each edge that runs upwards looks itself up.
void ConstrainedDelaunay2::mark_pieces() {
  const auto& pieces = pieces_.pieces;
  std::vector<std::uint32_t> order(pieces.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto less = [&](std::uint32_t p, const std::array<Vertex2, 2>& ends) {
    return pieces[p].source != ends[0] ? pieces[p].source < ends[0] : pieces[p].target < ends[1];
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return less(a, {pieces[b].source, pieces[b].target});
  });
  piece_of_.assign(3 * links_.triangle_count(), none);
  for (std::uint32_t t = 0; t < links_.triangle_count(); ++t) {
    for (unsigned slot = 0; slot < 3; ++slot) {
      const Edge2 e(Triangle2(t), slot);
      const Edge2 twin = links_.twin(e);
      const std::array<Vertex2, 2> ends{links_.source(e), links_.target(e)};
      const auto found = std::lower_bound(order.begin(), order.end(), ends, less);
      if (found == order.end() || pieces[*found].source != ends[0] || pieces[*found].target != ends[1]) continue;
      piece_of_[3 * std::size_t{t} + slot] = *found;
      piece_of_[3 * twin.triangle().index() + twin.slot()] = *found;
    }
  }
}

std::span<const std::uint32_t> ConstrainedDelaunay2::inputs(Vertex2 v) const {
  if (v.index() >= given_count()) return {};
  const std::uint32_t begin = pieces_.input_begin[v.index()];
  return std::span(pieces_.inputs).subspan(begin, pieces_.input_begin[v.index() + 1] - begin);
}

RationalPoint2 ConstrainedDelaunay2::exact(Vertex2 v) const {
  const RationalPoint3 p = pieces_.table.exact(id(v.index()));
  return {p.x, p.y};
}

Point2 ConstrainedDelaunay2::rounded(Vertex2 v) const {
  const Point3& p = pieces_.table.rounded(id(v.index()));
  return {p.x, p.y};
}

Sign ConstrainedDelaunay2::turn(Vertex2 a, Vertex2 b, Vertex2 c) const {
  return pieces_.table.turn_any(id(a.index()), id(b.index()), id(c.index()), axis);
}

Sign ConstrainedDelaunay2::circle_side(Vertex2 a, Vertex2 b, Vertex2 c, Vertex2 d) const {
  return pieces_.table.in_circle(id(a.index()), id(b.index()), id(c.index()), id(d.index()), axis);
}

Triangle2 ConstrainedDelaunay2::find_triangle(const Point2& query, const Context& context) const {
  if (!std::isfinite(query.x) || !std::isfinite(query.y)) throw InputError("the query is not finite");
  const RationalPoint2 exact_query{Rational(query.x), Rational(query.y)};
  const auto is_double = [&](Vertex2 v) { return v.index() < pieces_.table.explicit_count(); };
  const auto turn_to_query = [&](Vertex2 a, Vertex2 b) {
    if (is_double(a) && is_double(b)) return orientation(rounded(a), rounded(b), query);
    return turn_of(exact(a), exact(b), exact_query);
  };
  for (std::uint32_t t = 0; t < links_.triangle_count(); ++t) {
    if (t % 256 == 0) context.poll();
    if (links_.is_infinite(Triangle2(t))) continue;
    const auto v = links_.corners(Triangle2(t));
    if (turn_to_query(v[0], v[1]) != Sign::negative && turn_to_query(v[1], v[2]) != Sign::negative &&
        turn_to_query(v[2], v[0]) != Sign::negative) {
      return Triangle2(t);
    }
  }
  return {};
}

}  // namespace quoin
