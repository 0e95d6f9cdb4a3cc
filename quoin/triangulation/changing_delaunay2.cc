// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_delaunay2.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/changing_fill2.h"
#include "quoin/triangulation/delaunay_predicates2.h"

namespace quoin {

namespace {

using Insertion = detail::Insertion2<DelaunayPredicates2>;

constexpr std::uint32_t infinite = detail::changing_infinite;
constexpr std::size_t poll_step = 256;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Context& no_context() {
  static const Context context({.threads = 1});
  return context;
}

}  // namespace

ChangingDelaunay2::ChangingDelaunay2() : points_({nan, nan}) {}

ChangingDelaunay2::ChangingDelaunay2(std::span<const Point2> points, const Context& context) : ChangingDelaunay2() {
  const Delaunay2 delaunay(points, {}, context);
  const std::size_t count = delaunay.vertex_count();
  dimension_ = delaunay.dimension();
  for (std::size_t v = 0; v < count; ++v) {
    const Vertex2 added = points_.add(delaunay.points()[v]);
    for (std::size_t i = 1; i < delaunay.inputs(Vertex2(v)).size(); ++i) points_.add_once_more(added);
  }
  for (const Vertex2 v : delaunay.line()) line_.emplace_back(v.index() + 1);
  TriangleArray2 triangles(delaunay.links().links().begin(), delaunay.links().links().end());
  for (TriangleLinks2& t : triangles) {
    for (std::uint32_t& v : t.corner) v = v == count ? infinite : v + 1;
  }
  triangles_.reserve_vertices(count + 1);
  triangles_.assign(std::move(triangles));
}

Vertex2 ChangingDelaunay2::insert(const Point2& p) {
  return insert(p, no_context());
}

Vertex2 ChangingDelaunay2::insert(const Point2& given, const Context& context) {
  if (!std::isfinite(given.x) || !std::isfinite(given.y)) throw InputError("the point is not finite");
  const Point2 p{given.x + 0.0, given.y + 0.0};
  require_edge_codes(points_.id_count());
  return dimension_ < 2 ? insert_on_line(p, context) : insert_in_plane(p, context);
}

Vertex2 ChangingDelaunay2::insert_in_plane(const Point2& p, const Context& context) {
  context.poll();
  DelaunayPredicates2 predicates(points_.points(), infinite_vertex());
  Insertion insertion(predicates, triangles_.array(), infinite);
  const Vertex2 near = points_.one_near(p, [](Vertex2) { return true; });
  insertion.begin_at(near.is_none() ? 0 : edge_from(near).triangle().value);
  const std::uint32_t at = insertion.find(p, detail::WholePlane());
  for (const std::uint32_t corner : triangles()[at].corner) {
    const Vertex2 v(std::size_t{corner});
    if (v == infinite_vertex() || point(v) != p) continue;
    points_.add_once_more(v);
    return v;
  }
  const Vertex2 v = add_vertex(p);
  predicates = DelaunayPredicates2(points_.points(), infinite_vertex());
  try {
    insertion.begin_at(at);
    detail::insert_vertex(insertion, triangles_.array(), v.value);
  } catch (...) {
    points_.remove(v);
    throw;
  }
  for (const std::uint32_t t : insertion.star()) triangles_.update_edges(t);
  return v;
}

Vertex2 ChangingDelaunay2::add_vertex(const Point2& p) {
  triangles_.reserve_vertices(points_.id_count() + 1);
  return points_.add(p);
}

Vertex2 ChangingDelaunay2::insert_on_line(const Point2& p, const Context& context) {
  const auto less = [&](Vertex2 v, const Point2& q) { return lexicographically_less(point(v), q); };
  const auto after = std::lower_bound(line_.begin(), line_.end(), p, less);
  if (after != line_.end() && point(*after) == p) {
    points_.add_once_more(*after);
    return *after;
  }
  const bool leaves = line_.size() > 1 && orientation(point(line_.front()), point(line_.back()), p) != Sign::zero;
  const Vertex2 v = add_vertex(p);
  try {
    if (leaves) {
      leave_line(v, context);
      return v;
    }
    line_.insert(after, v);
  } catch (...) {
    points_.remove(v);
    throw;
  }
  dimension_ = line_.size() > 1 ? 1 : 0;
  return v;
}

// The first two of the line and the new point, then the others.
void ChangingDelaunay2::leave_line(Vertex2 apex, const Context& context) {
  const DelaunayPredicates2 predicates(points_.points(), infinite_vertex());
  triangles_.assign(detail::triangles_over_line(predicates, line_, apex, context));
  line_.clear();
  dimension_ = 2;
}

void ChangingDelaunay2::remove(Vertex2 v) {
  remove(v, no_context());
}

void ChangingDelaunay2::remove(Vertex2 v, const Context& context) {
  if (!lives(v)) throw InputError("there is no vertex " + std::to_string(v.value));
  if (multiplicity(v) > 1) {
    points_.remove_one_of_many(v);
    return;
  }
  points_.reserve_for_removal();
  if (dimension_ < 2) {
    line_.erase(std::find(line_.begin(), line_.end(), v));
    dimension_ = line_.empty() ? -1 : std::min(dimension_, line_.size() > 1 ? 1 : 0);
  } else {
    remove_from_plane(v, context);
  }
  points_.remove(v);
}

void ChangingDelaunay2::remove_from_plane(Vertex2 v, const Context& context) {
  detail::VertexStar2 star = triangles_.star(v);
  if (detail::is_apex_of_line(star, vertex_count(), points_.points(), context)) {
    fall_to_line(v, context);
    return;
  }
  const DelaunayPredicates2 predicates(points_.points(), infinite_vertex());
  const std::size_t made = detail::fill_star(predicates, triangles_.array(), star, context);
  for (std::size_t i = 0; i < made; ++i) triangles_.update_edges(star.triangles[i]);
  const auto holes = star.triangles.begin() + static_cast<std::ptrdiff_t>(made);
  std::sort(holes, star.triangles.end(), std::greater<>());
  std::for_each(holes, star.triangles.end(), [&](std::uint32_t t) { triangles_.drop(t); });
}

void ChangingDelaunay2::fall_to_line(Vertex2 gone, const Context& context) {
  std::vector<Vertex2> line;
  for (std::size_t v = 1; v < id_count(); ++v) {
    if (v % poll_step == 0) context.poll();
    if (lives(Vertex2(v)) && v != gone.index()) line.emplace_back(v);
  }
  std::sort(line.begin(), line.end(), [&](Vertex2 a, Vertex2 b) { return lexicographically_less(point(a), point(b)); });
  line_ = std::move(line);
  triangles_.assign({});
  dimension_ = line_.size() > 1 ? 1 : 0;
}

}  // namespace quoin
