// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_triangulation3.h"

#include <algorithm>
#include <string>
#include <utility>

#include "quoin/base/error.h"
#include "quoin/kernel/predicates3.h"
#include "quoin/triangulation/affine_basis.h"
#include "quoin/triangulation/canonical_cells.h"
#include "quoin/triangulation/circulators.h"
#include "quoin/triangulation/flat_cells.h"
#include "quoin/triangulation/flat_location.h"
#include "quoin/triangulation/lower_chain.h"
#include "quoin/triangulation/spatial_order.h"
#include "quoin/triangulation/triangulation_view3.h"

namespace quoin {

namespace {

const Point3& place_of(const Point3& site) {
  return site;
}
const Point3& place_of(const WeightedPoint3& site) {
  return site.point;
}

/// Cells of a plane as Delaunay3 has them: positive with the apex that it takes, of points along the curve.
void orient_by_apex(CellArray& cells, std::span<const Point3> points, const Context& context) {
  const Point3 apex = point_off_plane(points, affine_basis(points, context));
  const auto is_finite = [](const TriangulationCell& cell) { return cell.vertices[2] != vertex_at_infinity; };
  const auto& v = std::ranges::find_if(cells, is_finite)->vertices;
  if (orientation(points[v[0]], points[v[1]], points[v[2]], apex) == Sign::negative) turn_over(cells);
}

}  // namespace

template <class Points>
const Context& ChangingTriangulation3<Points>::no_context() {
  static const Context context({.threads = 1});
  return context;
}

template <class Points>
std::array<std::uint32_t, 4> ChangingTriangulation3<Points>::begin(const Context& context) {
  const std::vector<Point3> originals = points_.originals(points_.ids());
  const AffineBasis basis = affine_basis(originals, context);
  const std::vector<std::uint32_t>& v = basis.vertices;
  dimension_ = static_cast<int>(v.size()) - 1;
  if (dimension_ < 2) return {};
  if (dimension_ == 2) points_.add_apex(point_off_plane(originals, basis));
  return {v[0], v[1], v[2], dimension_ == 2 ? points_.apex() : v[3]};
}

template <class Points>
void ChangingTriangulation3<Points>::begin_line(const Context& context) {
  set_line(line_of(sorted_without(no_vertex), context));
}

template <class Points>
void ChangingTriangulation3<Points>::set_line(Line line) {
  line_ = std::move(line);
  const std::vector<std::uint32_t>& all = line_.all;
  dimension_ = all.empty() ? -1 : point(all.front()) == point(all.back()) ? 0 : 1;
}

template <class Points>
typename ChangingTriangulation3<Points>::Line ChangingTriangulation3<Points>::line_of(
    std::vector<std::uint32_t> all, [[maybe_unused]] const Context& context) const {
  Line line;
  if constexpr (Signs::may_hide) {
    for (const std::uint32_t place : lower_chain(points_.originals(all), points_.weights(all), context)) {
      line.shown.push_back(all[place]);
    }
  }
  line.all = std::move(all);
  return line;
}

/// All ids but one, as points of a line come one after the other.
template <class Points>
std::vector<std::uint32_t> ChangingTriangulation3<Points>::sorted_without(std::uint32_t v) const {
  std::vector<std::uint32_t> ids = points_.ids();
  std::erase(ids, v);
  std::ranges::sort(ids, [this](std::uint32_t a, std::uint32_t b) { return points_.is_before(a, points_.site(b)); });
  return ids;
}

template <class Points>
std::uint32_t ChangingTriangulation3<Points>::insert_site(const Site& site, const Context& context) {
  context.poll();
  if constexpr (Signs::may_hide) {
    const std::uint32_t known = points_.find(site);
    if (known != no_vertex) {
      points_.add_once_more(known);
      return known;
    }
  }
  if (dimension_ < 2) return insert_on_line(site, context);
  if (dimension_ == 2) {
    const int side = side_of_plane(place_of(site));
    if (side != 0) return insert_off_plane(site, side < 0);
  }
  return insert_among_cells(site, context);
}

template <class Points>
std::uint32_t ChangingTriangulation3<Points>::insert_among_cells(const Site& site, const Context& context) {
  const std::uint32_t near = points_.one_near(place_of(site));
  const std::uint32_t v = points_.add(site);
  try {
    const Signs signs = points_.signs();
    const std::uint32_t found = cells_.locate(signs, v, cells_.cell_of(near), context);
    if constexpr (!Signs::may_hide) {
      for (const std::uint32_t corner : cells_.cells()[found].vertices) {
        if (corner == vertex_at_infinity || point(corner) != site) continue;
        points_.remove(v);
        points_.add_once_more(corner);
        return corner;
      }
    }
    cells_.insert(signs, v, found, context);
  } catch (...) {
    points_.remove(v);
    throw;
  }
  return v;
}

template <class Points>
std::uint32_t ChangingTriangulation3<Points>::insert_on_line(const Site& site, const Context& context) {
  const std::vector<std::uint32_t>& all = line_.all;
  const auto less = [this](std::uint32_t v, const Site& other) { return points_.is_before(v, other); };
  const auto after = std::lower_bound(all.begin(), all.end(), site, less);
  if (after != all.end() && points_.site(*after) == site) {
    points_.add_once_more(*after);
    return *after;
  }
  if (all.size() > 1 && normal_axis(point(all.front()), point(all.back()), place_of(site)) < 3) {
    return insert_off_line(site, context);
  }
  std::vector<std::uint32_t> longer;
  longer.reserve(all.size() + 1);
  longer.assign(all.begin(), after);
  const std::uint32_t v = points_.add(site);
  longer.push_back(v);
  longer.insert(longer.end(), after, all.end());
  try {
    set_line(line_of(std::move(longer), context));
  } catch (...) {
    points_.remove(v);
    throw;
  }
  return v;
}

/// The cells of a plane: of the ends of the line, the new one and an apex; then the other points.
template <class Points>
std::uint32_t ChangingTriangulation3<Points>::insert_off_line(const Site& site, const Context& context) {
  const std::vector<std::uint32_t>& all = line_.all;
  std::vector<Point3> originals = points_.originals(all);
  originals.push_back(place_of(site));
  const auto last = static_cast<std::uint32_t>(all.size());
  const AffineBasis basis{{0, last - 1, last}, normal_axis(originals[0], originals[last - 1], originals[last])};
  const std::uint32_t v = points_.add(site);
  try {
    points_.add_apex(point_off_plane(originals, basis));
    const Signs signs = points_.signs();
    ChangingCells3<Signs> cells(signs, {all.front(), all.back(), v, points_.apex()}, points_.id_count());
    std::uint32_t near = v;
    for (std::size_t i = 1; i + 1 < all.size(); ++i) {
      const std::uint32_t found = cells.locate(signs, all[i], cells.cell_of(near), context);
      cells.insert(signs, all[i], found, context);
      near = all[i];
    }
    cells_ = std::move(cells);
  } catch (...) {
    if (points_.apex() != no_vertex) points_.remove_apex();
    points_.remove(v);
    throw;
  }
  line_ = {};
  dimension_ = 2;
  return v;
}

/// The point takes the place of the apex: all cells of an apex are those of any point on the same side, of any weight.
template <class Points>
std::uint32_t ChangingTriangulation3<Points>::insert_off_plane(const Site& site, bool is_beyond) {
  const std::uint32_t v = points_.turn_apex_into(site);
  if (is_beyond) cells_.turn_over();
  dimension_ = 3;
  return v;
}

/// Positive on the side of the apex.
template <class Points>
int ChangingTriangulation3<Points>::side_of_plane(const Point3& p) const {
  std::uint32_t cell = cells_.cell_of(points_.apex());
  if (cells_.is_ghost(cell)) cell = cells_.cells()[cell].neighbours[3] >> 2;
  const auto& v = cells_.cells()[cell].vertices;
  const auto& [a, b, c] = facet_slots[slot_of(cells_.cells()[cell], points_.apex())];
  return to_int(orientation(point(v[a]), point(v[b]), point(v[c]), p));
}

template <class Points>
void ChangingTriangulation3<Points>::remove(std::uint32_t v) {
  remove(v, no_context());
}

template <class Points>
void ChangingTriangulation3<Points>::remove(std::uint32_t v, const Context& context) {
  if (!lives(v)) throw InputError("there is no vertex " + std::to_string(v));
  context.poll();
  if (multiplicity(v) > 1) return points_.remove_one_of_many(v);
  points_.reserve_for_removals();
  if (dimension_ >= 2) return remove_from_cells(v, context);
  std::vector<std::uint32_t> shorter = line_.all;
  std::erase(shorter, v);
  set_line(line_of(std::move(shorter), context));
  points_.remove(v);
}

template <class Points>
void ChangingTriangulation3<Points>::remove_from_cells(std::uint32_t v, const Context& context) {
  if (cells_.is_hidden(v)) {
    cells_.remove_hidden(v);
  } else if (!cells_.remove(points_.signs(), v, context)) {
    return dimension_ == 3 ? fall_to_plane(v, context) : fall_to_line(v, context);
  }
  points_.remove(v);
}

/// The vertex becomes the apex, at a distance that suits the filters.
template <class Points>
void ChangingTriangulation3<Points>::fall_to_plane(std::uint32_t v, const Context& context) {
  std::vector<std::uint32_t> others = points_.ids();
  std::erase(others, v);
  std::vector<Point3> originals = points_.originals(others);
  if constexpr (Signs::may_hide) {
    std::ranges::sort(originals, [](const Point3& a, const Point3& b) { return lexicographically_less(a, b); });
    originals.erase(std::unique(originals.begin(), originals.end()), originals.end());
  }
  const Point3 apex = point_off_plane(originals, affine_basis(originals, context));
  points_.turn_into_apex(v, apex);
  dimension_ = 2;
  // The cells are oriented as if the apex were still there.
  if (side_of_plane(apex) < 0) cells_.turn_over();
}

template <class Points>
void ChangingTriangulation3<Points>::fall_to_line(std::uint32_t v, const Context& context) {
  Line line = line_of(sorted_without(v), context);
  ChangingCells3<Signs> none;
  cells_ = std::move(none);
  points_.remove_apex();
  points_.remove(v);
  set_line(std::move(line));
}

template <class Points>
void ChangingTriangulation3<Points>::require_vertex(std::uint32_t v) const {
  if (v == vertex_at_infinity) return;
  if (!lives(v)) throw InputError("there is no vertex " + std::to_string(v));
  if (cells_.is_hidden(v)) throw InputError("point " + std::to_string(v) + " is hidden");
}

template <class Points>
std::span<const TriangulationCell> ChangingTriangulation3<Points>::cells() const {
  if (dimension_ < 3) return {};
  return cells_.cells();
}

template <class Points>
std::span<const std::uint32_t> ChangingTriangulation3<Points>::line() const {
  return Signs::may_hide ? line_.shown : line_.all;
}

template <class Points>
std::vector<std::uint32_t> ChangingTriangulation3<Points>::star(std::uint32_t v) const {
  if (dimension_ < 3) throw InputError("stars of vertices are given in dimension 3 only");
  require_vertex(v);
  std::vector<std::uint32_t> list;
  find_star(cells_.cells(), 4, v, cell_of(v), list);
  return list;
}

template <class Points>
std::vector<std::uint32_t> ChangingTriangulation3<Points>::neighbours(std::uint32_t v) const {
  if (dimension_ < 2) throw InputError("neighbours of vertices are given in dimension 2 and 3 only");
  require_vertex(v);
  std::vector<std::uint32_t> star;
  std::vector<std::uint32_t> list;
  find_star(cells_.cells(), 4, v, cell_of(v), star);
  find_link_vertices(cells_.cells(), 4, v, star, list);
  std::erase(list, points_.apex());
  return list;
}

template <class Points>
DelaunayLocation ChangingTriangulation3<Points>::locate(const Point3& p) const {
  require_finite(p);
  if (dimension_ < 3) return locate_among_flat(p);
  const std::uint32_t start = cell_of(points_.one_near(p));
  return *walk_to(p, any_steps, cells(), start, [this](std::uint32_t v) { return point(v); });
}

template <class Points>
DelaunayLocation ChangingTriangulation3<Points>::locate_among_flat(const Point3& p) const {
  if (dimension_ < 0) throw InputError("there is no vertex");
  const CellArray flat = flat_cells();
  std::vector<Point3> points(id_count());
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (lives(v)) points[v] = point(v);
  }
  const FlatLocator locator(TriangulationView3(flat, points, dimension_));
  if (dimension_ < 2) return locator.locate_on_line(p);
  if (!locator.spans(p)) return {DelaunayLocation::Kind::outside_affine_hull, 0, 0};
  return *locator.walk_in_plane(p, 0, any_steps);
}

template <class Points>
CellArray ChangingTriangulation3<Points>::flat_cells() const {
  if (dimension_ == 2) return without_apex(cells_.cells(), points_.apex());
  if (dimension_ == 0 || dimension_ == 1) return cells_of_chain(line());
  return {};
}

template <class Points>
NumberedCells ChangingTriangulation3<Points>::canonical_cells(const Context& context) const {
  NumberedCells numbered;
  if (dimension_ < 0) return numbered;
  const std::vector<std::uint32_t> ids = points_.ids();
  const std::vector<Point3> originals = points_.originals(ids);
  std::vector<std::uint32_t> number(id_count());
  std::vector<Point3> along_curve;
  for (const std::uint32_t i : hilbert_order(originals, context)) {
    const std::uint32_t v = ids[i];
    if (along_curve.empty() || along_curve.back() != originals[i]) {
      numbered.ids.push_back(v);
      along_curve.push_back(originals[i]);
    } else if (points_.is_before(v, points_.site(numbered.ids.back()))) {
      numbered.ids.back() = v;
    }
    number[v] = static_cast<std::uint32_t>(numbered.ids.size() - 1);
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

template class ChangingTriangulation3<ChangingPoints3>;
template class ChangingTriangulation3<ChangingWeightedPoints3>;

}  // namespace quoin
