// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_delaunay2.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/cavity_fill2.h"
#include "quoin/triangulation/delaunay_predicates2.h"
#include "quoin/triangulation/insertion2.h"

namespace quoin {

namespace {

using Insertion = detail::Insertion2<DelaunayPredicates2>;

constexpr std::size_t infinite = 0;
constexpr std::size_t poll_step = 256;

const Context& no_context() {
  static const Context context({.threads = 1});
  return context;
}

// Room for one more, in steps that grow.
template <class List>
void make_room(List& list) {
  if (list.size() == list.capacity()) list.reserve(2 * list.size() + 1);
}

// Inserts a vertex, with places for its triangles at the end of the array, which is as it was where that fails.
void insert_vertex(Insertion& insertion, TriangleArray2& triangles, std::uint32_t v) {
  const std::size_t count = triangles.size();
  triangles.resize(count + 2);
  try {
    insertion.insert(v, static_cast<std::uint32_t>(count), detail::WholePlane());
  } catch (...) {
    triangles.resize(count);
    throw;
  }
}

}  // namespace

ChangingDelaunay2::ChangingDelaunay2() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  points_.push_back({nan, nan});
  multiplicity_.push_back(0);
  star_.push_back(Vertex2::none_value);
}

ChangingDelaunay2::ChangingDelaunay2(std::span<const Point2> points, const Context& context) : ChangingDelaunay2() {
  const Delaunay2 delaunay(points, {}, context);
  count_ = delaunay.vertex_count();
  dimension_ = delaunay.dimension();
  for (std::size_t v = 0; v < count_; ++v) {
    points_.push_back(delaunay.points()[v]);
    multiplicity_.push_back(static_cast<std::uint32_t>(delaunay.inputs(Vertex2(v)).size()));
  }
  star_.assign(points_.size(), Vertex2::none_value);
  for (const Vertex2 v : delaunay.line()) line_.emplace_back(v.index() + 1);
  triangles_.assign(delaunay.links().links().begin(), delaunay.links().links().end());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::uint32_t& v : triangles_[t].corner) v = v == count_ ? infinite : v + 1;
    update_star(t);
  }
}

Vertex2 ChangingDelaunay2::insert(const Point2& p) {
  return insert(p, no_context());
}

Vertex2 ChangingDelaunay2::insert(const Point2& given, const Context& context) {
  if (!std::isfinite(given.x) || !std::isfinite(given.y)) throw InputError("the point is not finite");
  const Point2 p{given.x + 0.0, given.y + 0.0};
  require_edge_codes(points_.size());
  return dimension_ < 2 ? insert_on_line(p, context) : insert_in_plane(p, context);
}

Vertex2 ChangingDelaunay2::insert_in_plane(const Point2& p, const Context& context) {
  context.poll();
  DelaunayPredicates2 predicates(points_, infinite_vertex());
  Insertion insertion(predicates, triangles_, infinite);
  insertion.begin_at(nearby_triangle(p));
  const std::uint32_t at = insertion.find(p, detail::WholePlane());
  for (const std::uint32_t corner : triangles_[at].corner) {
    if (corner == infinite || points_[corner] != p) continue;
    ++multiplicity_[corner];
    return Vertex2(std::size_t{corner});
  }
  const Vertex2 v = add_vertex(p);
  predicates = DelaunayPredicates2(points_, infinite_vertex());
  try {
    insertion.begin_at(at);
    insert_vertex(insertion, triangles_, v.value);
    for (const std::uint32_t t : insertion.star()) update_star(t);
  } catch (...) {
    take_back(v);
    throw;
  }
  return v;
}

Vertex2 ChangingDelaunay2::add_vertex(const Point2& p) {
  if (free_.empty()) {
    make_room(points_);
    make_room(multiplicity_);
    make_room(star_);
    make_room(free_);  // for take_back
    free_.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p);
    multiplicity_.push_back(0);
    star_.push_back(Vertex2::none_value);
  }
  const Vertex2 v(std::size_t{free_.back()});
  free_.pop_back();
  points_[v.index()] = p;
  multiplicity_[v.index()] = 1;
  ++count_;
  return v;
}

// The vertex that was added last, where nothing came of it.
void ChangingDelaunay2::take_back(Vertex2 v) {
  --count_;
  multiplicity_[v.index()] = 0;
  free_.push_back(v.value);
}

Vertex2 ChangingDelaunay2::insert_on_line(const Point2& p, const Context& context) {
  const auto less = [&](Vertex2 v, const Point2& q) { return lexicographically_less(point(v), q); };
  const auto after = std::lower_bound(line_.begin(), line_.end(), p, less);
  if (after != line_.end() && point(*after) == p) {
    ++multiplicity_[after->index()];
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
    take_back(v);
    throw;
  }
  dimension_ = line_.size() > 1 ? 1 : 0;
  return v;
}

// The first two of the line and the new point, then the others.
void ChangingDelaunay2::leave_line(Vertex2 apex, const Context& context) {
  std::array<std::uint32_t, 3> corners{line_[0].value, line_[1].value, apex.value};
  if (orientation(point(line_[0]), point(line_[1]), point(apex)) == Sign::negative) std::swap(corners[0], corners[1]);
  const DelaunayPredicates2 predicates(points_, infinite_vertex());
  TriangleArray2 triangles(4);
  Insertion insertion(predicates, triangles, infinite);
  insertion.start(corners);
  for (std::size_t i = 2; i < line_.size(); ++i) {
    if (i % poll_step == 2) context.poll();
    insert_vertex(insertion, triangles, line_[i].value);
  }
  triangles_ = std::move(triangles);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) update_star(t);
  line_.clear();
  dimension_ = 2;
}

void ChangingDelaunay2::remove(Vertex2 v) {
  remove(v, no_context());
}

void ChangingDelaunay2::remove(Vertex2 v, const Context& context) {
  if (v == infinite_vertex() || !lives(v)) throw InputError("there is no vertex " + std::to_string(v.value));
  if (multiplicity_[v.index()] == 1) {
    make_room(free_);
    if (dimension_ < 2) {
      line_.erase(std::find(line_.begin(), line_.end(), v));
      dimension_ = line_.empty() ? -1 : std::min(dimension_, line_.size() > 1 ? 1 : 0);
    } else {
      remove_from_plane(v, context);
    }
    free_.push_back(v.value);
    --count_;
  }
  --multiplicity_[v.index()];
}

void ChangingDelaunay2::remove_from_plane(Vertex2 v, const Context& context) {
  // Edges from v, counterclockwise.
  std::vector<std::uint32_t> ring;
  std::uint32_t code = star_[v.index()];
  do {
    ring.push_back(code);
    code = triangles_[code / 4].across[previous_slot(code % 4)];
  } while (code != star_[v.index()]);
  if (falls_without(ring, context)) {
    fall_to_line(v, context);
  } else {
    fill_star(ring, context);
  }
}

bool ChangingDelaunay2::falls_without(std::span<const std::uint32_t> ring, const Context& context) const {
  std::vector<std::uint32_t> others;
  for (const std::uint32_t code : ring) {
    const std::uint32_t other = triangles_[code / 4].corner[previous_slot(code % 4)];
    if (other != infinite) others.push_back(other);
  }
  if (others.size() + 1 != count_) return false;
  for (std::size_t i = 2; i < others.size(); ++i) {
    if (i % poll_step == 0) context.poll();
    if (orientation(points_[others[0]], points_[others[1]], points_[others[i]]) != Sign::zero) return false;
  }
  return true;
}

void ChangingDelaunay2::fall_to_line(Vertex2 gone, const Context& context) {
  std::vector<Vertex2> line;
  for (std::size_t v = 1; v < points_.size(); ++v) {
    if (v % poll_step == 0) context.poll();
    if (lives(Vertex2(v)) && v != gone.index()) line.emplace_back(v);
  }
  std::sort(line.begin(), line.end(), [&](Vertex2 a, Vertex2 b) { return lexicographically_less(point(a), point(b)); });
  line_ = std::move(line);
  triangles_.clear();
  dimension_ = line_.size() > 1 ? 1 : 0;
}

void ChangingDelaunay2::fill_star(std::span<const std::uint32_t> ring, const Context& context) {
  std::vector<std::uint32_t> ids;
  std::vector<std::uint32_t> outer;
  std::vector<std::uint32_t> corners;
  for (const std::uint32_t code : ring) {
    ids.push_back(code / 4);
    outer.push_back(triangles_[code / 4].across[next_slot(code % 4)]);
    corners.push_back(triangles_[code / 4].corner[previous_slot(code % 4)]);
  }
  const DelaunayPredicates2 predicates(points_, infinite_vertex());
  detail::CavityFill2<DelaunayPredicates2> fill(predicates, triangles_, infinite, context);
  fill.begin(ids, outer);
  // The hole is on the left of the first edge; the other corners go back from its source to its target.
  std::reverse(corners.begin() + 2, corners.end());
  fill.fill(corners[0], corners[1], std::span(corners).subspan(2), true);
  const std::size_t made = fill.end();
  for (std::size_t i = 0; i < made; ++i) update_star(ids[i]);
  std::sort(ids.begin() + static_cast<std::ptrdiff_t>(made), ids.end(), std::greater<>());
  for (std::size_t i = made; i < ids.size(); ++i) drop_triangle(ids[i]);
}

// The last triangle takes the place.
void ChangingDelaunay2::drop_triangle(std::uint32_t t) {
  const auto last = static_cast<std::uint32_t>(triangles_.size() - 1);
  if (t != last) {
    triangles_[t] = triangles_[last];
    for (unsigned slot = 0; slot < 3; ++slot) {
      const std::uint32_t other = triangles_[t].across[slot];
      triangles_[other / 4].across[other % 4] = 4 * t + slot;
    }
    update_star(t);
  }
  triangles_.pop_back();
}

void ChangingDelaunay2::update_star(std::uint32_t t) {
  for (unsigned slot = 0; slot < 3; ++slot) star_[triangles_[t].corner[slot]] = 4 * t + previous_slot(slot);
}

// About the nearest of a few vertices, evenly spaced ids; rounded distances do.
std::uint32_t ChangingDelaunay2::nearby_triangle(const Point2& p) const {
  const std::size_t ids = points_.size() - 1;
  const auto samples = 1 + static_cast<std::size_t>(std::cbrt(static_cast<double>(ids)));
  std::uint32_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < samples; ++i) {
    const Vertex2 v(1 + ids * i / samples);
    if (!lives(v)) continue;
    const double distance = std::hypot(point(v).x - p.x, point(v).y - p.y);
    if (!(distance < least)) continue;
    least = distance;
    best = star_[v.index()] / 4;
  }
  return best;
}

}  // namespace quoin
