// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/changing_delaunay3.h"

#include <array>
#include <cmath>
#include <new>

#include "quoin/base/error.h"
#include "quoin/triangulation/delaunay_cells.h"
#include "quoin/triangulation/insertion_rounds.h"

namespace quoin {

ChangingDelaunay3::ChangingDelaunay3(std::span<const Point3> points, const Context& context) try {
  if (points.empty()) return;
  points_ = ChangingPoints3(VertexPoints(points, Scaling::allowed, context));
  const std::size_t count = points_.count();
  const std::array<std::uint32_t, 4> simplex = begin(context);
  if (dimension_ < 2) {
    begin_line(context);
    return;
  }
  cells_ = ChangingCells3<DelaunaySigns>(
      delaunay_cells(points_.signs(), count, simplex, InsertionSplit::of(count), context), points_.id_count());
} catch (const std::bad_alloc&) {
  refuse_for_memory(points.size());
}

std::uint32_t ChangingDelaunay3::insert(const Point3& p) {
  return insert(p, no_context());
}

std::uint32_t ChangingDelaunay3::insert(const Point3& p, const Context& context) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) throw InputError("the point is not finite");
  return insert_site({p.x + 0.0, p.y + 0.0, p.z + 0.0}, context);
}

std::uint32_t ChangingDelaunay3::nearest(const Point3& p) const {
  require_finite(p);
  if (dimension_ < 0) throw InputError("there is no vertex");
  const auto at = [this](std::uint32_t v) { return point(v); };
  if (dimension_ < 2) {
    return walk_to_nearest(p, line().front(), at, [this](std::uint32_t) { return line(); });
  }
  const std::uint32_t near = points_.one_near(p);
  const std::uint32_t start = near == vertex_at_infinity ? neighbours(near).front() : near;
  return walk_to_nearest(p, start, at, [this](std::uint32_t v) { return neighbours(v); });
}

}  // namespace quoin
