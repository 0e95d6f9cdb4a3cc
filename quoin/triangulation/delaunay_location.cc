// SPDX-License-Identifier: Apache-2.0
#include "quoin/triangulation/delaunay_location.h"

#include <cmath>

#include "quoin/base/error.h"

namespace quoin {

DelaunayLocation DelaunayLocator::locate(const Point3& p, std::uint32_t start) const {
  require_finite(p);
  const TriangulationView3& t = triangulation_;
  if (t.dimension() < 3) throw InputError("points are located in triangulations of dimension 3 only");
  return walk_to(p, t.cells(), start < t.cells().size() ? start : 0, [&t](std::uint32_t v) { return t.point(v); });
}

int DelaunayLocator::compare(const Point3& p, std::uint32_t v, std::uint32_t w) const {
  const TriangulationView3& t = triangulation_;
  return compare_powers(p, t.point(v), t.weight(v), t.point(w), t.weight(w));
}

std::uint32_t DelaunayLocator::nearest(const Point3& p) const {
  require_finite(p);
  const auto count = static_cast<std::uint32_t>(triangulation_.vertex_count());
  // As many samples as steps are saved by them.
  const auto samples = static_cast<std::uint32_t>(std::cbrt(static_cast<double>(count))) + 1;
  std::uint32_t best = triangulation_.cells()[0].vertices[0];
  if (best == vertex_at_infinity) best = triangulation_.cells()[0].vertices[1];
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto v = static_cast<std::uint32_t>(std::uint64_t{i} * count / samples);
    if (stars_.cell(v) != VertexStars::no_cell && compare(p, v, best) < 0) best = v;
  }
  return walk_to_least(
      best, [&](std::uint32_t v, std::uint32_t w) { return compare(p, v, w); },
      [this](std::uint32_t v) { return stars_.neighbours(v); });
}

}  // namespace quoin
