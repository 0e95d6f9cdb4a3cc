// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_delaunay3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/canonical_cells.h"
#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/delaunay_cells.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/insertion_rounds.h"
#include "quoin/triangulation/spatial_order.h"

namespace quoin {

namespace {

const Context& no_context() {
  static const Context context({.threads = 1});
  return context;
}

/// Cells of a plane as Delaunay3 has them: positive with the apex that it takes, of points along the curve.
void orient_by_apex(CellArray& cells, std::span<const Point3> points, const Context& context) {
  const Point3 apex = point_off_plane(points, affine_basis(points, context));
  const auto is_finite = [](const TriangulationCell& cell) { return cell.vertices[2] != vertex_at_infinity; };
  const auto& v = std::ranges::find_if(cells, is_finite)->vertices;
  if (orientation(points[v[0]], points[v[1]], points[v[2]], apex) == Sign::negative) turn_over(cells);
}

}  // namespace

ChangingDelaunay3::ChangingDelaunay3(std::span<const Point3> points, const Context& context) try {
  if (points.empty()) return;
  points_ = ChangingPoints3(VertexPoints(points, Scaling::allowed, context));
  const std::size_t count = points_.count();
  const std::vector<std::uint32_t> ids = points_.ids();
  const std::vector<Point3> originals = points_.originals(ids);
  const AffineBasis basis = affine_basis(originals, context);
  const std::vector<std::uint32_t>& v = basis.vertices;
  dimension_ = static_cast<int>(v.size()) - 1;
  if (dimension_ < 2) {
    line_ = ids;
    std::ranges::sort(
        line_, [&](std::uint32_t a, std::uint32_t b) { return lexicographically_less(originals[a], originals[b]); });
    return;
  }
  if (dimension_ == 2) points_.add_apex(point_off_plane(originals, basis));
  const std::array<std::uint32_t, 4> simplex{v[0], v[1], v[2], dimension_ == 2 ? points_.apex() : v[3]};
  cells_ = ChangingCells3(delaunay_cells(points_.signs(), count, simplex, InsertionSplit::of(count), context),
                          points_.id_count());
} catch (const std::bad_alloc&) {
  refuse_for_memory(points.size());
}

std::uint32_t ChangingDelaunay3::insert(const Point3& p) {
  return insert(p, no_context());
}

std::uint32_t ChangingDelaunay3::insert(const Point3& given, const Context& context) {
  if (!std::isfinite(given.x) || !std::isfinite(given.y) || !std::isfinite(given.z)) {
    throw InputError("the point is not finite");
  }
  context.poll();
  const Point3 p{given.x + 0.0, given.y + 0.0, given.z + 0.0};
  if (dimension_ < 2) return insert_on_line(p, context);
  if (dimension_ == 2) {
    const int side = side_of_plane(p);
    if (side != 0) return insert_off_plane(p, side < 0);
  }
  return insert_among_cells(p, context);
}

std::uint32_t ChangingDelaunay3::insert_among_cells(const Point3& p, const Context& context) {
  const std::uint32_t near = points_.one_near(p);
  const std::uint32_t v = points_.add(p);
  try {
    const DelaunaySigns signs = points_.signs();
    const std::uint32_t found = cells_.locate(signs, v, cells_.cell_of(near), context);
    for (const std::uint32_t corner : cells_.cells()[found].vertices) {
      if (corner == vertex_at_infinity || point(corner) != p) continue;
      points_.remove(v);
      points_.add_once_more(corner);
      return corner;
    }
    cells_.insert(signs, v, found, context);
  } catch (...) {
    points_.remove(v);
    throw;
  }
  return v;
}

std::uint32_t ChangingDelaunay3::insert_on_line(const Point3& p, const Context& context) {
  const auto less = [this](std::uint32_t v, const Point3& q) { return lexicographically_less(point(v), q); };
  const auto after = std::lower_bound(line_.begin(), line_.end(), p, less);
  if (after != line_.end() && point(*after) == p) {
    points_.add_once_more(*after);
    return *after;
  }
  if (line_.size() > 1 && normal_axis(point(line_.front()), point(line_.back()), p) < 3) {
    return insert_off_line(p, context);
  }
  const auto place = after - line_.begin();
  line_.reserve(line_.size() + 1);
  const std::uint32_t v = points_.add(p);
  line_.insert(line_.begin() + place, v);
  dimension_ = line_.size() > 1 ? 1 : 0;
  return v;
}

/// The cells of a plane: of two points of the line, the new one and an apex; then the other points.
std::uint32_t ChangingDelaunay3::insert_off_line(const Point3& p, const Context& context) {
  std::vector<Point3> originals = points_.originals(line_);
  originals.push_back(p);
  const auto last = static_cast<std::uint32_t>(line_.size());
  const AffineBasis basis{{0, 1, last}, normal_axis(originals[0], originals[1], p)};
  const std::uint32_t v = points_.add(p);
  try {
    points_.add_apex(point_off_plane(originals, basis));
    const DelaunaySigns signs = points_.signs();
    ChangingCells3 cells(signs, {line_[0], line_[1], v, points_.apex()}, points_.id_count());
    for (std::size_t i = 2; i < line_.size(); ++i) {
      const std::uint32_t found = cells.locate(signs, line_[i], cells.cell_of(line_[i - 1]), context);
      cells.insert(signs, line_[i], found, context);
    }
    cells_ = std::move(cells);
  } catch (...) {
    if (points_.apex() != no_vertex) points_.remove_apex();
    points_.remove(v);
    throw;
  }
  line_.clear();
  dimension_ = 2;
  return v;
}

/// The point takes the place of the apex: all cells of an apex are those of any point on the same side.
std::uint32_t ChangingDelaunay3::insert_off_plane(const Point3& p, bool is_beyond) {
  if (is_beyond) cells_.turn_over();
  dimension_ = 3;
  return points_.turn_apex_into(p);
}

/// Positive on the side of the apex.
int ChangingDelaunay3::side_of_plane(const Point3& p) const {
  std::uint32_t cell = cells_.cell_of(points_.apex());
  if (cells_.is_ghost(cell)) cell = cells_.cells()[cell].neighbours[3] >> 2;
  const auto& v = cells_.cells()[cell].vertices;
  const auto& [a, b, c] = facet_slots[slot_of(cells_.cells()[cell], points_.apex())];
  return to_int(orientation(point(v[a]), point(v[b]), point(v[c]), p));
}

void ChangingDelaunay3::require_vertex(std::uint32_t v) const {
  if (!lives(v)) throw InputError("there is no vertex " + std::to_string(v));
}

void ChangingDelaunay3::remove(std::uint32_t v) {
  remove(v, no_context());
}

void ChangingDelaunay3::remove(std::uint32_t v, const Context& context) {
  require_vertex(v);
  context.poll();
  if (multiplicity(v) > 1) return points_.remove_one_of_many(v);
  points_.reserve_for_removals();
  if (dimension_ < 2) {
    line_.erase(std::ranges::find(line_, v));
    dimension_ = std::min(dimension_, static_cast<int>(line_.size()) - 1);
  } else if (!cells_.remove(points_.signs(), v, context)) {
    return dimension_ == 3 ? fall_to_plane(v, context) : fall_to_line(v);
  }
  points_.remove(v);
}

/// The vertex becomes the apex, at a distance that suits the filters.
void ChangingDelaunay3::fall_to_plane(std::uint32_t v, const Context& context) {
  std::vector<std::uint32_t> others = points_.ids();
  std::erase(others, v);
  const std::vector<Point3> originals = points_.originals(others);
  const Point3 apex = point_off_plane(originals, affine_basis(originals, context));
  points_.turn_into_apex(v, apex);
  dimension_ = 2;
  // The cells are oriented as if the apex were still there.
  if (side_of_plane(apex) < 0) cells_.turn_over();
}

void ChangingDelaunay3::fall_to_line(std::uint32_t v) {
  std::vector<std::uint32_t> line = points_.ids();
  std::erase(line, v);
  std::ranges::sort(line,
                    [this](std::uint32_t a, std::uint32_t b) { return lexicographically_less(point(a), point(b)); });
  ChangingCells3 none;
  line_ = std::move(line);
  cells_ = std::move(none);
  points_.remove_apex();
  points_.remove(v);
  dimension_ = line_.size() > 1 ? 1 : 0;
}

std::span<const TriangulationCell> ChangingDelaunay3::cells() const {
  if (dimension_ < 3) return {};
  return cells_.cells();
}

std::vector<std::uint32_t> ChangingDelaunay3::star(std::uint32_t v) const {
  if (dimension_ < 3) throw InputError("stars of vertices are given in dimension 3 only");
  if (v != vertex_at_infinity) require_vertex(v);
  std::vector<std::uint32_t> list;
  find_star(cells_.cells(), 4, v, cell_of(v), list);
  return list;
}

std::vector<std::uint32_t> ChangingDelaunay3::neighbours(std::uint32_t v) const {
  if (dimension_ < 2) throw InputError("neighbours of vertices are given in dimension 2 and 3 only");
  if (v != vertex_at_infinity) require_vertex(v);
  std::vector<std::uint32_t> star;
  std::vector<std::uint32_t> list;
  find_star(cells_.cells(), 4, v, cell_of(v), star);
  find_link_vertices(cells_.cells(), 4, v, star, list);
  std::erase(list, points_.apex());
  return list;
}

DelaunayLocation ChangingDelaunay3::locate(const Point3& p) const {
  require_finite(p);
  if (dimension_ < 3) throw InputError("points are located in triangulations of dimension 3 only");
  return walk_to(p, cells(), cell_of(points_.one_near(p)), [this](std::uint32_t v) { return point(v); });
}

std::uint32_t ChangingDelaunay3::nearest(const Point3& p) const {
  require_finite(p);
  if (dimension_ < 0) throw InputError("there is no vertex");
  const auto at = [this](std::uint32_t v) { return point(v); };
  if (dimension_ < 2) {
    return walk_to_nearest(p, line_.front(), at, [this](std::uint32_t) { return line_; });
  }
  const std::uint32_t near = points_.one_near(p);
  const std::uint32_t start = near == vertex_at_infinity ? neighbours(near).front() : near;
  return walk_to_nearest(p, start, at, [this](std::uint32_t v) { return neighbours(v); });
}

CellArray ChangingDelaunay3::flat_cells() const {
  if (dimension_ == 2) return without_apex(cells_.cells(), points_.apex());
  if (dimension_ == 0 || dimension_ == 1) return cells_of_chain(line_);
  return {};
}

NumberedCells ChangingDelaunay3::canonical_cells(const Context& context) const {
  NumberedCells numbered;
  if (dimension_ < 0) return numbered;
  const std::vector<std::uint32_t> ids = points_.ids();
  const std::vector<Point3> originals = points_.originals(ids);
  std::vector<std::uint32_t> number(id_count());
  std::vector<Point3> along_curve;
  for (const std::uint32_t i : hilbert_order(originals, context)) {
    number[ids[i]] = static_cast<std::uint32_t>(numbered.ids.size());
    numbered.ids.push_back(ids[i]);
    along_curve.push_back(originals[i]);
  }
  numbered.cells = dimension_ == 3 ? cells_.cells() : flat_cells();
  for (TriangulationCell& cell : numbered.cells) {
    for (std::uint32_t& v : cell.vertices) {
      if (v < vertex_at_infinity) v = number[v];
    }
  }
  if (dimension_ == 2) orient_by_apex(numbered.cells, along_curve, context);
  sort_cells(numbered.cells, dimension_);
  return numbered;
}

}  // namespace quoin
