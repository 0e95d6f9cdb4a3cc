// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_regular2.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/point_hash.h"
#include "quoin/kernel/predicates2.h"
#include "quoin/triangulation/changing_fill2.h"
#include "quoin/triangulation/insertion_round.h"
#include "quoin/triangulation/spatial_order2.h"

namespace quoin {

// A point and the triangle that holds it; none if the point is a vertex.
struct ChangingRegular2::Holder {
  std::uint32_t point;
  std::uint32_t triangle;
};

namespace {

using Insertion = detail::Insertion2<RegularPredicates2>;

constexpr std::uint32_t infinite = detail::changing_infinite;
constexpr std::uint32_t none = Vertex2::none_value;
constexpr std::size_t poll_step = 256;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Context& no_context() {
  static const Context context({.threads = 1});
  return context;
}

// The whole plane, with a poll now and then: many triangles may be in conflict.
class PolledPlane {
 public:
  explicit PolledPlane(const Context& context) : context_(context) {}
  bool allows(std::uint32_t /*v*/) {
    if (++asked_ % poll_step == 0) context_.poll();
    return true;
  }
  static constexpr bool owns(const std::array<std::uint32_t, 3>& /*triangle*/) { return true; }

 private:
  const Context& context_;
  std::size_t asked_ = 0;
};

std::size_t hash_of(const WeightedPoint2& p) {
  return hash_of(Point3{p.point.x, p.point.y, p.weight});
}

auto hash_of_id(const ChangingRegular2& changing) {
  return [&changing](std::uint32_t id) { return hash_of(changing.point(Vertex2(std::size_t{id}))); };
}

bool is_same(const WeightedPoint2& a, const WeightedPoint2& b) {
  return a.point == b.point && a.weight == b.weight;
}

WeightedPoint2 without_negative_zeros(const WeightedPoint2& p) {
  return {{p.point.x + 0.0, p.point.y + 0.0}, p.weight + 0.0};
}

bool is_corner(const TriangleLinks2& t, std::uint32_t v) {
  return t.corner[0] == v || t.corner[1] == v || t.corner[2] == v;
}

// Inserts those of the points that are no vertices and not hidden, in rounds of growing size (Amenta, Choi and Rote
// 2003).
void reveal(Insertion& insertion, TriangleArray2& triangles, const RegularPredicates2& predicates,
            const std::vector<std::uint32_t>& points, const Context& context) {
  std::size_t tried = 0;
  for (unsigned round = insertion_rounds; round-- > 0;) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (insertion_round(i) != round) continue;
      if (tried++ % 64 == 0) context.poll();  // exact arithmetic of large spans takes long
      const WeightedPoint2& p = predicates.point(points[i]);
      const std::uint32_t at = insertion.find(p, detail::WholePlane());
      insertion.begin_at(at);
      if (is_corner(triangles[at], points[i]) || !predicates.in_conflict(triangles[at], p)) continue;
      insertion.conflicts(at, p, PolledPlane(context));
      const auto count = static_cast<std::uint32_t>(triangles.size());
      triangles.resize(triangles.size() + 2);
      insertion.replace_conflicts(points[i], count);
    }
  }
}

// Where a triangle holds a vertex, the vertex is a corner.
template <class Holder>
std::vector<Holder> find_holders(Insertion& insertion, const TriangleArray2& triangles,
                                 const RegularPredicates2& predicates, const std::vector<std::uint32_t>& points,
                                 const Context& context) {
  std::vector<Holder> holders;
  holders.reserve(points.size());
  for (const std::uint32_t v : points) {
    if (holders.size() % poll_step == 0) context.poll();
    const std::uint32_t at = insertion.find(predicates.point(v), detail::WholePlane());
    insertion.begin_at(at);
    holders.push_back({v, is_corner(triangles[at], v) ? none : at});
  }
  return holders;
}

}  // namespace

ChangingRegular2::ChangingRegular2() : points_({{nan, nan}, nan}) {
  hidden_.reserve(1, 1);
}

ChangingRegular2::ChangingRegular2(std::span<const WeightedPoint2> points, const Context& context)
    : ChangingRegular2() {
  const Regular2 regular(points, context);
  const std::size_t count = regular.vertex_count();
  for (std::size_t i = 0; i < count; ++i) {
    if (i % poll_step == 0) context.poll();
    const Vertex2 v = add(regular.point(Vertex2(i)));
    for (std::size_t more = regular.inputs(Vertex2(i)).size(); more > 1; --more) points_.add_once_more(v);
  }
  std::vector<std::uint32_t> hidden;
  for (const std::uint32_t input : regular.hidden()) {
    if (hidden.size() % poll_step == 0) context.poll();
    const WeightedPoint2 p = without_negative_zeros(points[input]);
    const Vertex2 known = find(p);
    if (known.is_none()) {
      hidden.push_back(add(p).value);
    } else {
      points_.add_once_more(known);
    }
  }
  dimension_ = regular.dimension();
  for (const Vertex2 v : regular.line()) line_.emplace_back(v.index() + 1);
  if (dimension_ < 2) {
    for (const std::uint32_t v : hidden) hidden_.put(v, on_line);
    return;
  }
  const std::span<const TriangleLinks2> links = regular.links().links();
  TriangleArray2 triangles(links.begin(), links.end());
  for (TriangleLinks2& t : triangles) {
    for (std::uint32_t& v : t.corner) v = v == count ? infinite : v + 1;
  }
  hidden_.reserve(0, triangles.size());
  triangles_.assign(std::move(triangles));
  const RegularPredicates2 predicates(points_.points(), infinite_vertex());
  Insertion insertion(predicates, triangles_.array(), infinite);
  hold(find_holders<Holder>(insertion, triangles_.array(), predicates, along_curve(hidden, context), context));
}

Vertex2 ChangingRegular2::find(const WeightedPoint2& given) const {
  const WeightedPoint2 p = without_negative_zeros(given);
  const auto is_it = [&](std::uint32_t id) { return is_same(point(Vertex2(std::size_t{id})), p); };
  const std::uint32_t id = ids_.find(hash_of(p), is_it);
  return id == none ? Vertex2() : Vertex2(std::size_t{id});
}

// All that is kept for each point has room before anything changes.
Vertex2 ChangingRegular2::add(const WeightedPoint2& p) {
  triangles_.reserve_vertices(id_count() + 1);
  hidden_.reserve(id_count() + 1, 0);
  ids_.reserve_one(hash_of_id(*this));
  const Vertex2 v = points_.add(p);
  ids_.put(v.value, hash_of(p));
  return v;
}

void ChangingRegular2::forget(Vertex2 v) {
  ids_.take(v.value, hash_of_id(*this));
  points_.remove(v);
}

Vertex2 ChangingRegular2::insert(const WeightedPoint2& p) {
  return insert(p, no_context());
}

Vertex2 ChangingRegular2::insert(const WeightedPoint2& given, const Context& context) {
  if (!std::isfinite(given.point.x) || !std::isfinite(given.point.y)) throw InputError("the point is not finite");
  if (!std::isfinite(given.weight)) throw InputError("the weight is not finite");
  const WeightedPoint2 p = without_negative_zeros(given);
  const Vertex2 known = find(p);
  if (!known.is_none()) {
    points_.add_once_more(known);
    return known;
  }
  require_edge_codes(id_count());
  const Vertex2 v = add(p);
  try {
    if (dimension_ < 2) {
      insert_on_line(v, context);
    } else {
      insert_in_plane(v, context);
    }
  } catch (...) {
    forget(v);
    throw;
  }
  return v;
}

void ChangingRegular2::insert_in_plane(Vertex2 v, const Context& context) {
  context.poll();
  const WeightedPoint2 p = point(v);
  const RegularPredicates2 predicates(points_.points(), infinite_vertex());
  TriangleArray2& triangles = triangles_.array();
  Insertion insertion(predicates, triangles, infinite);
  const Vertex2 near = points_.one_near(p.point, [&](Vertex2 other) { return other != v && !is_hidden(other); });
  insertion.begin_at(near.is_none() ? 0 : edge_from(near).triangle().value);
  const std::uint32_t at = insertion.find(p, detail::WholePlane());
  if (!predicates.in_conflict(triangles[at], p)) {
    hidden_.put(v.value, at);
    return;
  }
  const std::span<const std::uint32_t> conflicts = insertion.conflicts(at, p, PolledPlane(context));
  detail::TriangleRollback before(triangles, conflicts);
  std::vector<std::uint32_t> moved = held_by(conflicts, context);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  triangles.resize(triangles.size() + 2);
  hidden_.reserve(0, triangles.size());
  insertion.replace_conflicts(v.value, count);
  const std::vector<std::uint32_t> now_hidden = inside(before, insertion.star(), context);
  moved.insert(moved.end(), now_hidden.begin(), now_hidden.end());
  const std::vector<Holder> holders = find_holders<Holder>(insertion, triangles, predicates, moved, context);

  before.keep();
  hold(holders);
  for (const std::uint32_t t : insertion.star()) triangles_.update_edges(t);
  drop(insertion.left_over());
}

void ChangingRegular2::remove(Vertex2 v) {
  remove(v, no_context());
}

void ChangingRegular2::remove(Vertex2 v, const Context& context) {
  if (!lives(v)) throw InputError("there is no point " + std::to_string(v.value));
  if (multiplicity(v) > 1) {
    points_.remove_one_of_many(v);
    return;
  }
  points_.reserve_for_removal();
  if (is_hidden(v)) {
    hidden_.take(v.value);
  } else if (dimension_ < 2) {
    remove_from_line(v, context);
  } else {
    remove_from_plane(v, context);
  }
  forget(v);
}

void ChangingRegular2::remove_from_plane(Vertex2 v, const Context& context) {
  context.poll();
  detail::VertexStar2 star = triangles_.star(v);
  const std::vector<std::uint32_t> held = held_by(star.triangles, context);
  if (detail::is_apex_of_line(star, vertex_count(), points_.points(), context)) {
    remove_apex(star, held, context);
  } else {
    refill(std::move(star), held, context);
  }
}

// All other vertices lie on a line; what is hidden may not, and is in the triangles of this one.
void ChangingRegular2::remove_apex(const detail::VertexStar2& star, const std::vector<std::uint32_t>& held,
                                   const Context& context) {
  std::vector<Vertex2> line;
  for (const std::uint32_t corner : star.corners) {
    if (corner != infinite) line.emplace_back(std::size_t{corner});
  }
  std::sort(line.begin(), line.end(), [&](Vertex2 a, Vertex2 b) { return lexicographically_less(place(a), place(b)); });
  const auto is_off_line = [&](std::uint32_t id) {
    return orientation(place(line.front()), place(line.back()), place(Vertex2(std::size_t{id}))) != Sign::zero;
  };
  const auto apex = std::find_if(held.begin(), held.end(), is_off_line);
  if (apex != held.end()) {
    build_over_line(line, Vertex2(std::size_t{*apex}), held, context);
    return;
  }
  for (const std::uint32_t id : held) {
    hidden_.take(id);
    hidden_.put(id, on_line);
  }
  triangles_.assign({});
  set_line(std::move(line));
}

// What is revealed lies in the filled star, as all other triangles are still without points below them.
void ChangingRegular2::refill(detail::VertexStar2 star, const std::vector<std::uint32_t>& held,
                              const Context& context) {
  const RegularPredicates2 predicates(points_.points(), infinite_vertex());
  TriangleArray2& triangles = triangles_.array();
  const std::vector<std::uint32_t> points = along_curve(held, context);
  const std::size_t count = triangles.size();
  detail::TriangleRollback before(triangles, star.triangles);
  const std::size_t made = detail::fill_star(predicates, triangles, star, context);
  Insertion insertion(predicates, triangles, infinite);
  insertion.begin_at(star.triangles[0]);
  reveal(insertion, triangles, predicates, points, context);
  const std::vector<Holder> holders = find_holders<Holder>(insertion, triangles, predicates, points, context);
  std::vector<std::uint32_t>& holes = insertion.left_over();
  holes.insert(holes.end(), star.triangles.begin() + static_cast<std::ptrdiff_t>(made), star.triangles.end());
  hidden_.reserve(0, triangles.size());

  before.keep();
  hold(holders);
  const auto update = [&](std::uint32_t t) {
    if (!insertion.is_left_over(t)) triangles_.update_edges(t);
  };
  for (std::size_t i = 0; i < made; ++i) update(star.triangles[i]);
  for (std::size_t t = count; t < triangles.size(); ++t) update(static_cast<std::uint32_t>(t));
  drop(holes);
}

void ChangingRegular2::build_over_line(std::span<const Vertex2> line, Vertex2 apex,
                                       const std::vector<std::uint32_t>& held, const Context& context) {
  const RegularPredicates2 predicates(points_.points(), infinite_vertex());
  const std::vector<std::uint32_t> points = along_curve(held, context);
  TriangleArray2 triangles = detail::triangles_over_line(predicates, line, apex, context);
  Insertion insertion(predicates, triangles, infinite);
  reveal(insertion, triangles, predicates, points, context);
  std::vector<std::uint32_t>& holes = insertion.left_over();
  std::sort(holes.begin(), holes.end(), std::greater<>());
  for (const std::uint32_t hole : holes) detail::close_hole(triangles, hole);
  insertion.begin_at(0);
  const std::vector<Holder> holders = find_holders<Holder>(insertion, triangles, predicates, points, context);
  hidden_.reserve(0, triangles.size());

  hold(holders);
  triangles_.assign(std::move(triangles));
  line_.clear();
  dimension_ = 2;
}

std::vector<std::uint32_t> ChangingRegular2::held_by(std::span<const std::uint32_t> triangles,
                                                     const Context& context) const {
  std::vector<std::uint32_t> points;
  std::size_t visited = 0;
  for (const std::uint32_t t : triangles) {
    if (visited++ % poll_step == 0) context.poll();
    for (std::uint32_t id = hidden_.first(t); id != none; id = hidden_.next(id)) {
      if (visited++ % poll_step == 0) context.poll();
      points.push_back(id);
    }
  }
  return points;
}

// Vertices inside of what a star has replaced; they have their edges there.
std::vector<std::uint32_t> ChangingRegular2::inside(const detail::TriangleRollback& before,
                                                    std::span<const std::uint32_t> star, const Context& context) const {
  std::vector<std::uint32_t> vertices;
  if (before.ids().size() + 2 == star.size()) return vertices;
  std::vector<std::uint32_t> rim;
  for (const std::uint32_t t : star) rim.insert(rim.end(), triangles()[t].corner.begin(), triangles()[t].corner.end());
  std::sort(rim.begin(), rim.end());
  for (std::size_t i = 0; i < before.ids().size(); ++i) {
    if (i % poll_step == 0) context.poll();
    for (unsigned slot = 0; slot < 3; ++slot) {
      const std::uint32_t v = before.links()[i].corner[slot];
      if (edge_from(Vertex2(std::size_t{v})).code != 4 * before.ids()[i] + previous_slot(slot)) continue;
      if (!std::binary_search(rim.begin(), rim.end(), v)) vertices.push_back(v);
    }
  }
  return vertices;
}

std::vector<std::uint32_t> ChangingRegular2::along_curve(const std::vector<std::uint32_t>& ids,
                                                         const Context& context) const {
  constexpr std::size_t few = 32;  // are near each other in any order
  if (ids.size() <= few) return ids;
  std::vector<Point2> places;
  places.reserve(ids.size());
  for (const std::uint32_t id : ids) places.push_back(place(Vertex2(std::size_t{id})));
  std::vector<std::uint32_t> sorted;
  sorted.reserve(ids.size());
  for (const std::uint32_t i : spatial_order(places, context).inputs) sorted.push_back(ids[i]);
  return sorted;
}

// Takes no memory.
void ChangingRegular2::hold(std::span<const Holder> holders) {
  for (const Holder& h : holders) {
    if (is_hidden(Vertex2(std::size_t{h.point}))) hidden_.take(h.point);
    if (h.triangle != none) hidden_.put(h.point, h.triangle);
  }
}

// Takes no memory.
void ChangingRegular2::drop(std::span<std::uint32_t> holes) {
  std::sort(holes.begin(), holes.end(), std::greater<>());
  for (const std::uint32_t hole : holes) {
    hidden_.move(static_cast<std::uint32_t>(triangles().size() - 1), hole);
    triangles_.drop(hole);
  }
}

}  // namespace quoin
